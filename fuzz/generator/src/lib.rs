//! turnspec-generator.
