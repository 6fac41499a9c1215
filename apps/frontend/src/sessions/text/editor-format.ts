/** Value of `format` that marks the JSON text of a session as editor data. */
export const EDITOR_FORMAT = 'ubi-interact.graph';
export const EDITOR_VERSION = 1;
