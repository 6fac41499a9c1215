/** Bit of the flight recorder in the targets of a record. */
export const FLIGHT_TARGET = 1;
