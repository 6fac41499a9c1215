/** Platforms that differ in permissions and in the installation of certificates and apps. */
export type Platform = 'ios' | 'android' | 'windows' | 'macos' | 'linux';

/** @param touchPoints `maxTouchPoints`: an iPad identifies itself as a Mac, which has no touchscreen */
export function platformOf(userAgent: string, touchPoints: number): Platform {
  if (/\b(iPhone|iPad|iPod)\b/.test(userAgent)) return 'ios';
  if (/\bAndroid\b/.test(userAgent)) return 'android';
  if (/\bMacintosh\b/.test(userAgent)) return touchPoints > 1 ? 'ios' : 'macos';
  return /\bWindows\b/.test(userAgent) ? 'windows' : 'linux';
}

/** The platform of this browser. */
export function thisPlatform(): Platform {
  return platformOf(navigator.userAgent, navigator.maxTouchPoints);
}
