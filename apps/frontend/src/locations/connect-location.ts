/** Path of the page for connecting phones. */
export const CONNECT_PATH = '/connect';
