/** Escapes a CSV field; texts that spreadsheets would evaluate as a formula are quoted as text. */
export function csvField(value: string): string {
  const text = /^[=+@\t\r-]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
