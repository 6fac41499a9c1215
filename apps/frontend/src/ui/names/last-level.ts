/** Returns the last level of a topic with its slash; empty for other texts and for topics with one level. */
export function lastLevel(text: string): string {
  const slash = text.lastIndexOf('/');
  return slash > 0 && slash < text.length - 1 ? text.slice(slash) : '';
}
