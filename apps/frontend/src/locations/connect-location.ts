/** Path of the page for connecting phones. */
export const CONNECT_PATH = '/connect';
/** Path of the page for connecting a program of one's own. */
export const CONNECT_PROGRAM_PATH = '/clients/program';
