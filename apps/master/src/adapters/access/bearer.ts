/** Valid tokens are shorter: ignore longer texts. */
const MAX_LENGTH = 1_024;
/** Tokens and credentials are longer than any typed code. */
const MIN_TOKEN_LENGTH = 40;

/** Returns the token after `Bearer`; undefined for other authentication schemes, which are not supported. [AC-3] */
export function bearerOf(authorization: string | undefined): string | undefined {
  if (authorization === undefined) return undefined;
  const match = /^bearer(?: +(.*))?$/i.exec(authorization.trim());
  if (match === null) return undefined;
  const bearer = match[1]?.trim() ?? '';
  return bearer.length > MAX_LENGTH ? '' : bearer;
}

/** Whether this may be a token or credential, and is no code: codes are guessed. [AC-46] */
export function mayBeToken(bearer: string | undefined): boolean {
  return bearer !== undefined && bearer.length >= MIN_TOKEN_LENGTH;
}
