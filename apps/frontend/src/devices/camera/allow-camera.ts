/** Instructions for allowing the camera, by browser; the first match counts. */
const WAYS: readonly (readonly [agent: RegExp, way: string])[] = [
  [/\b(iPhone|iPad)\b.*\bCriOS\//, 'Open the system settings, choose Chrome, and turn Camera on.'],
  [
    /\b(iPhone|iPad)\b/,
    'Tap the page icon left of the address, choose Website Settings, and set Camera to Allow.',
  ],
  [
    /\bAndroid\b.*\bFirefox\//,
    'Tap the lock left of the address, choose Camera, and set it to Allowed.',
  ],
  [/\bAndroid\b/, 'Tap the icon left of the address, choose Permissions, and turn Camera on.'],
  [/\bFirefox\//, 'Click the camera icon left of the address, and remove “Blocked” beside Camera.'],
  [
    /\b(Chrome|HeadlessChrome|Chromium|Edg)\//,
    'Click the icon left of the address, and turn Camera on.',
  ],
  [/\bSafari\//, 'Choose Settings for This Website in the Safari menu, and set Camera to Allow.'],
];
const ANY_WAY = 'Allow it in the browser’s settings of this page, beside the address.';

/** Returns instructions for this browser after the camera was refused, one sentence. */
export function allowCameraWay(userAgent: string): string {
  return WAYS.find(([agent]) => agent.test(userAgent))?.[1] ?? ANY_WAY;
}
