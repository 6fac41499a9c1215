/** Longer names do not fit beside the values they belong to. Characters. */
export const MAX_NAME_LENGTH = 60;
