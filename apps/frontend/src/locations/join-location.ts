import type { RouteLocationRaw } from 'vue-router';

/** Where strangers come to. The token of a QR code stands in the fragment. [AC-5] [AC-11] */
export const JOIN_PATH = '/join';

/** In the query: who is in already wants to join with another code. */
export const ANOTHER = 'another';

/** Where one joins with another code. @param to path of the page to come back to */
export function anotherCode(to: string): RouteLocationRaw {
  return { path: JOIN_PATH, query: { [ANOTHER]: '', to } };
}

/** In the query, for `ANOTHER`: what is wanted is to become admin. */
export const TO_ADMIN = 'admin';

/** Where one becomes admin with a code. @param to path of the page to come back to */
export function adminCode(to: string): RouteLocationRaw {
  return { path: JOIN_PATH, query: { [ANOTHER]: TO_ADMIN, to } };
}
