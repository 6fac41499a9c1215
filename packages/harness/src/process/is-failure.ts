/**
 * Returns whether a log line reports a defect: a JSON line of level `error`, or an error or warning that Node itself
 * printed.
 */
export function isFailure(line: string): boolean {
  if (line.startsWith('{')) {
    try {
      return (JSON.parse(line) as { level?: string }).level === 'error';
    } catch {
      return true;
    }
  }
  return /^\s+at .+:\d+:\d+\)?$|^\w*Error\b|^\(node:\d+\)/.test(line);
}
