//! Moments of inertia of plane and solid bodies, and where their centres of mass are.
