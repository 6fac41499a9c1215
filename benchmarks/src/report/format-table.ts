/** Columns padded to their widest cell; cells that look like numbers go to the right. */
export function formatTable(
  header: readonly string[],
  rows: readonly (readonly string[])[],
): string {
  const all = [header, ...rows];
  const widths = header.map((_, column) =>
    Math.max(...all.map((row) => (row[column] ?? '').length)),
  );
  const isNumeric = header.map((_, column) =>
    rows.every((row) => /^$|^[-+<>=]*\s*[\d.]/.test(row[column] ?? '')),
  );
  return all
    .map((row) =>
      widths
        .map((width, column) =>
          isNumeric[column]
            ? (row[column] ?? '').padStart(width)
            : (row[column] ?? '').padEnd(width),
        )
        .join('  ')
        .trimEnd(),
    )
    .join('\n');
}

/** Three significant digits, thousands as k and M: 4.21 M, 183 k, 20.4, 0.59. */
export function formatNumber(value: number): string {
  if (!Number.isFinite(value)) return '–';
  if (value >= 999_500) return `${(value / 1e6).toPrecision(3)} M`;
  if (value >= 9_995) return `${(value / 1e3).toPrecision(3)} k`;
  return value >= 1000 ? value.toFixed(0) : String(Number(value.toPrecision(3)));
}
