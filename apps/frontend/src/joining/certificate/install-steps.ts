import type { Platform } from '../../connection/platform.ts';

/** Instructions for trusting the authority on one operating system, and for removing it. */
export interface InstallGuide {
  readonly platform: Platform;
  readonly name: string;
  /** Certificate file in the format that this operating system installs. */
  readonly file: { readonly href: string; readonly text: string };
  readonly steps: readonly string[];
  readonly removal: string;
}

/** Menu names are those of current versions; older ones differ slightly. */
export const INSTALL_GUIDES: readonly InstallGuide[] = [
  {
    platform: 'ios',
    name: 'iPhone, iPad',
    file: { href: '/ca.mobileconfig', text: 'Download the profile' },
    steps: [
      'Open this page in Safari, download the profile and tap Allow.',
      'Open Settings. Tap “Profile Downloaded” at the top, then Install, and compare the fingerprint under “More Details”.',
      'Go to Settings, General, About, Certificate Trust Settings. Turn on full trust for this certificate. Without this step, iOS still rejects it.',
      'Return to this page and open the secure page.',
    ],
    removal: 'Settings, General, VPN & Device Management: choose the profile, Remove Profile.',
  },
  {
    platform: 'android',
    name: 'Android',
    file: { href: '/ca.crt', text: 'Download the certificate' },
    steps: [
      'Download the certificate. If the browser asks, keep the file.',
      'Open Settings and search for “CA certificate” (Security, More security settings, Install from storage).',
      'Choose “Install anyway”, confirm with the screen lock of the phone and select ubi-interact.crt.',
      'Return to this page and open the secure page. Firefox on Android also needs Settings, Secret settings, “Use third party CA certificates”.',
    ],
    removal:
      'Settings, search for “User credentials” or “Trusted credentials”, User: choose it, Remove.',
  },
  {
    platform: 'windows',
    name: 'Windows',
    file: { href: '/ca.crt', text: 'Download the certificate' },
    steps: [
      'Download the certificate and open the file. Choose Install Certificate, Current User.',
      'Choose “Place all certificates in the following store”, Browse, “Trusted Root Certification Authorities”.',
      'Compare the fingerprint and confirm. Restart the browser.',
    ],
    removal:
      'Run certmgr.msc, Trusted Root Certification Authorities, Certificates: delete the certificate of Ubi-Interact.',
  },
  {
    platform: 'macos',
    name: 'macOS',
    file: { href: '/ca.pem', text: 'Download the certificate' },
    steps: [
      'Download the certificate and open the file. Keychain Access adds it to the login keychain.',
      'Double-click it there and compare the fingerprint.',
      'Under Trust, choose “Always Trust” for “When using this certificate”, close and confirm. Restart the browser.',
    ],
    removal: 'Keychain Access, login, Certificates: delete the certificate of Ubi-Interact.',
  },
  {
    platform: 'linux',
    name: 'Linux, Firefox',
    file: { href: '/ca.pem', text: 'Download the certificate' },
    steps: [
      'Firefox, on every system: Settings, Privacy & Security, View Certificates, Authorities, Import. Choose the file and tick “Trust this CA to identify websites”.',
      'Chrome and Chromium: Settings, Privacy and security, Security, Manage certificates, Authorities or Custom, Import.',
      'Programs of the system: copy the file to /usr/local/share/ca-certificates/ubi-interact.crt and run update-ca-certificates.',
    ],
    removal:
      'In the browser, delete it in the same place. On the system, delete the file and run update-ca-certificates --fresh.',
  },
];

export function guideFor(platform: Platform): InstallGuide {
  return INSTALL_GUIDES.find((guide) => guide.platform === platform) ?? INSTALL_GUIDES[0]!;
}

/** The master's information about its authority. */
export interface AuthorityFacts {
  readonly name: string;
  /** SHA-256, pairs of hex digits separated by colons. */
  readonly fingerprint: string;
  /** Epoch milliseconds. */
  readonly validToMs: number;
}

/** @returns `none` when this master has no authority of its own */
export async function askAuthority(): Promise<AuthorityFacts | 'none'> {
  const response = await fetch('/ca.json', { cache: 'no-store' });
  if (!response.ok) throw new Error(`Ubi-Interact answered with ${response.status}.`);
  const facts = (await response.json()) as Partial<AuthorityFacts>;
  return facts.fingerprint === undefined ? 'none' : (facts as AuthorityFacts);
}
