/** Name and version of the library, sent at registration in the form of a User-Agent. [EX-25] */
export const LIBRARY_NAME = 'client-web/0.2.0';
