/** Id of the open drawer. */
export const DRAWER_ID = 'session-drawer';
