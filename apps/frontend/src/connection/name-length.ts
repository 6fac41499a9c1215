/** Longest name, characters; longer ones do not fit beside values. */
export const MAX_NAME_LENGTH = 60;
