/** Longest reason, characters: it fits, with a name, into a close reason of 123 bytes. [EX-30] */
export const MAX_REASON_LENGTH = 80;
