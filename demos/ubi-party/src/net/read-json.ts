/**
 * An object that somebody told as text; undefined when it is none. Whoever may publish on a topic may publish anything:
 * what matters of it is checked by who reads it.
 */
export function readJson<T extends object>(text: string): Partial<T> | undefined {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null ? (value as Partial<T>) : undefined;
  } catch {
    return undefined;
  }
}
