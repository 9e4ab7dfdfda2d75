//! When a value is passed: the inverse of the motion.
