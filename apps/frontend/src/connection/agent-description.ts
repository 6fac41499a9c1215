/** What a user agent says about its maker, in the order in which the words must be looked for. */
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

/** The few words people know a browser by: `iPhone, Safari`. */
export function describeAgent(userAgent: string): string {
  const words = [find(SYSTEMS, userAgent), find(BROWSERS, userAgent)];
  return words.filter((word) => word !== undefined).join(', ') || 'Browser';
}
