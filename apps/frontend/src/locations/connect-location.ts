/** Where phones are connected. */
export const CONNECT_PATH = '/connect';
