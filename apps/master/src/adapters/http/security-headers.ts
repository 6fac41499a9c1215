/**
 * Sources that pages may load and run: none from other origins, no inline scripts. Components of libraries set inline
 * styles; workers and pictures are created from blobs. Sent with every file of the frontend: a worker obeys the policy
 * of its own response, not that of its page.
 *
 * @param otherMasters origins of the other masters of the cluster, which a page asks when its own is lost [CU-91]
 */
export const contentSecurityPolicy = (otherMasters: readonly string[]): string =>
  [
    "default-src 'self'",
    "script-src 'self' 'wasm-unsafe-eval'",
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' data: blob:",
    "font-src 'self' data:",
    "worker-src 'self' blob:",
    ["connect-src 'self' ws: wss:", ...otherMasters].join(' '),
    "object-src 'none'",
    "base-uri 'self'",
    "form-action 'self'",
    "frame-ancestors 'self'",
  ].join('; ');

/** Device features that pages use, each after the user's permission. */
const USED_FEATURES = [
  'accelerometer',
  'autoplay',
  'camera',
  'clipboard-read',
  'clipboard-write',
  'fullscreen',
  'gamepad',
  'geolocation',
  'gyroscope',
  'magnetometer',
  'microphone',
  'screen-wake-lock',
];

/** Device features that pages do not use, disabled for injected code. */
const UNUSED_FEATURES = [
  'browsing-topics',
  'compute-pressure',
  'display-capture',
  'encrypted-media',
  'hid',
  'identity-credentials-get',
  'idle-detection',
  'keyboard-map',
  'local-fonts',
  'midi',
  'otp-credentials',
  'payment',
  'picture-in-picture',
  'publickey-credentials-create',
  'publickey-credentials-get',
  'serial',
  'speaker-selection',
  'storage-access',
  'sync-xhr',
  'usb',
  'window-management',
  'xr-spatial-tracking',
];

/**
 * Sent with every response. Services are called across origins by requests that ask for leave (CORS), to
 * which `cross-origin-resource-policy` does not apply; it keeps other pages from embedding what is here.
 */
export const SECURITY_HEADERS: Readonly<Record<string, string>> = {
  'x-content-type-options': 'nosniff',
  'referrer-policy': 'no-referrer',
  'cross-origin-opener-policy': 'same-origin',
  'cross-origin-resource-policy': 'same-origin',
  'permissions-policy': [
    ...USED_FEATURES.map((feature) => `${feature}=(self)`),
    ...UNUSED_FEATURES.map((feature) => `${feature}=()`),
  ].join(', '),
};
