/** What the client says of its library at registration: name and version, as in a User-Agent. [EX-25] */
export const LIBRARY_NAME = 'client-web/0.1.0';
