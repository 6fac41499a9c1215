/** Patterns of browsers in user agents, in the order in which they must be tested. */
const BROWSERS = [
  [/\bEdg(e|A|iOS)?\//, 'Edge'],
  [/\b(OPR|Opera)\//, 'Opera'],
  [/\bSamsungBrowser\//, 'Samsung Internet'],
  [/\b(Firefox|FxiOS)\//, 'Firefox'],
  [/\b(Chrome|HeadlessChrome|Chromium|CriOS)\//, 'Chrome'],
  [/\bSafari\//, 'Safari'],
] as const;

const SYSTEMS = [
  [/\biPhone\b/, 'iPhone'],
  [/\biPad\b/, 'iPad'],
  [/\bQuest\b/, 'Quest'],
  [/\bAndroid\b/, 'Android'],
  [/\bCrOS\b/, 'ChromeOS'],
  [/\bMac OS X\b/, 'macOS'],
  [/\bWindows\b/, 'Windows'],
  [/\bLinux\b/, 'Linux'],
] as const;

const find = (words: readonly (readonly [RegExp, string])[], agent: string): string | undefined =>
  words.find(([pattern]) => pattern.test(agent))?.[1];

/** Short description of a browser: `iPhone, Safari`. */
export function describeAgent(userAgent: string): string {
  const words = [find(SYSTEMS, userAgent), find(BROWSERS, userAgent)];
  return words.filter((word) => word !== undefined).join(', ') || 'Browser';
}
