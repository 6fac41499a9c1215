/** The default of an input for people: of `{"double":1}` the 1; undefined where there is none. */
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
