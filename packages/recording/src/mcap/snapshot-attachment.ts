/** Name of the attachments that hold the last value of each channel, as a row of MCAP message records. */
export const SNAPSHOT_NAME = 'ubi-interact/last-values';
/** Their media type. */
export const SNAPSHOT_TYPE = 'application/x-ubi-interact.last-values';
