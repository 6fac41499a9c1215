/** What fits beside a name into the reason of a close, which has 123 bytes. [EX-30] Characters. */
export const MAX_REASON_LENGTH = 80;
