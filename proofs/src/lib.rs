//! turnspec-proofs.
