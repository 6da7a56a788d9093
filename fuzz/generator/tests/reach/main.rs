//! What generated programs reach: of each area how many, how deep, and every rule and alarm. One program, so that the areas
//! are run at once.

mod barriers;
mod citations;
mod compensation;
mod contour;
mod control;
mod cutter;
mod cycles;
mod deeds;
mod io;
mod lap;
mod programs;
mod threads;
mod turrets;
