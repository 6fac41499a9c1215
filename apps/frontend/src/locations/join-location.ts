import type { RouteLocationRaw } from 'vue-router';

/** Path of the join page. The token of a QR code is in the fragment. [AC-5] [AC-11] */
export const JOIN_PATH = '/join';

/** Query parameter for a connected client that wants to join with another code. */
export const ANOTHER = 'another';

/** Location for joining with another code. @param to path of the page to return to */
export function anotherCode(to: string): RouteLocationRaw {
  return { path: JOIN_PATH, query: { [ANOTHER]: '', to } };
}

/** Value of `ANOTHER` for becoming an admin. */
export const TO_ADMIN = 'admin';

/** Location for becoming an admin with a code. @param to path of the page to return to */
export function adminCode(to: string): RouteLocationRaw {
  return { path: JOIN_PATH, query: { [ANOTHER]: TO_ADMIN, to } };
}
