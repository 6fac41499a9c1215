/** A path of this origin, as somebody else wrote it; the start page for anything else. */
export function safeTarget(path: unknown): string {
  return typeof path === 'string' && /^\/(?![/\\])[^\s\\]*$/.test(path) ? path : '/';
}
