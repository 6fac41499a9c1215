/**
 * Records of more bytes are large: they are not joined with others in one piece of memory, because to copy them, and to get
 * memory for them, costs more than an object does.
 */
export const MAX_JOINED_BYTES = 16 * 1024;
