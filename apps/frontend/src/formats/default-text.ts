/** Formats the default of an input: `1` for `{"double":1}`; undefined without one. */
export function defaultText(json: string | undefined): string | undefined {
  if (json === undefined) return undefined;
  try {
    const [value] = Object.values(JSON.parse(json) as object) as unknown[];
    if (value === undefined || value === null) return undefined;
    return typeof value === 'object' ? JSON.stringify(value) : String(value);
  } catch {
    return undefined;
  }
}
