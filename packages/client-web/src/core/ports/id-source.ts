/** Gives new ids: version 4 UUIDs in lower-case letters. */
export type IdSource = () => string;
