/** Returns a path of this origin from an untrusted text; the start page for other texts. */
export function safeTarget(path: unknown): string {
  return typeof path === 'string' && /^\/(?![/\\])[^\s\\]*$/.test(path) ? path : '/';
}
