/** A field of a table; what spreadsheets take for a formula is made a text. */
export function csvText(value: string): string {
  const text = /^[=+@\t\r-]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
