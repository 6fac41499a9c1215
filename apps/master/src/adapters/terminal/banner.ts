import { MasterAddressKind } from '@ubii/proto';
import type { TerminalAccess } from '../../core/master/master.ts';
import type { ListeningPorts } from '../network/listeners.ts';
import type { Reachability } from '../network/reachability.ts';
import type { LoopbackFacts } from '../access/caller-reader.ts';

/** A QR code for a terminal, in its own colours: dark on light whatever the theme. */
export async function formatQrCode(text: string): Promise<string> {
  // Needed once, and by few: not worth the time at every start.
  const { default: qrcode } = await import('qrcode');
  return qrcode.toString(text, { type: 'terminal', small: true, errorCorrectionLevel: 'M' });
}

/**
 * Output of `--print-endpoints json`: one line of JSON for programs that start a master.
 *
 * @param terminal secrets for becoming admin and for joining
 */
export function formatEndpoints(localUrl: string, pid: number, terminal?: TerminalAccess): string {
  const { admin, join } = terminal ?? {};
  return JSON.stringify({
    url: localUrl,
    servicesJson: `${localUrl}/services/json`,
    servicesBinary: `${localUrl}/services/binary`,
    topicDataWs: `${localUrl.replace(/^http/, 'ws')}/topicdata`,
    pid,
    ...(admin && { adminToken: admin.token, adminCode: admin.code }),
    ...(join && { joinToken: join.token, joinCode: join.code }),
  });
}

interface Secrets {
  readonly token: string;
  readonly code: string;
}

interface BannerSecrets {
  readonly admin: Secrets;
  readonly join: Secrets | undefined;
}

interface BannerFacts {
  readonly name: string;
  readonly version: string;
  readonly dataDir: string;
  readonly ports: ListeningPorts;
  readonly reachability: Reachability;
  /** Secrets for becoming admin and for joining; undefined when the master could not create them. */
  readonly terminal: BannerSecrets | undefined;
  /** Role of callers on this computer without a token. */
  readonly loopback: LoopbackFacts;
  /** Address of the development server that serves the pages instead of the master. */
  readonly devUrl: string | undefined;
}

const KIND_NAMES: Readonly<Record<number, string>> = {
  [MasterAddressKind.WIFI]: 'Wi-Fi',
  [MasterAddressKind.ETHERNET]: 'Ethernet',
  [MasterAddressKind.VIRTUAL]: 'virtual network',
  [MasterAddressKind.PUBLIC]: 'public address',
};

/** The address a phone should be given: the best one that is not of a virtual network. */
export function bestPhoneUrl({ networkAddresses }: Reachability): string | undefined {
  const real = networkAddresses.find(({ kind }) => kind !== MasterAddressKind.VIRTUAL);
  return (real ?? networkAddresses[0])?.url;
}

/** The link that a phone opens to join. The token is in the fragment, which browsers do not send. [AC-11] */
export function joinUrl(origin: string, token: string): string {
  return `${origin}/join#${token}`;
}

/** Text for the user who started the master: addresses and next steps. */
export function formatBanner(facts: BannerFacts): string {
  const { name, version, dataDir, ports, reachability, terminal, loopback, devUrl } = facts;
  const { localUrl, networkAddresses } = reachability;
  const join = terminal?.join;
  const admin = loopback.role === 'admin' ? undefined : terminal?.admin;
  const asAdmin = (url: string): string => (admin === undefined ? url : joinUrl(url, admin.token));
  const rows: (readonly [string, string])[] = [
    ...(devUrl === undefined ? [] : [['Pages (hot reload)', asAdmin(devUrl)] as const]),
    ['On this machine', asAdmin(localUrl)],
    ...(admin === undefined
      ? []
      : [
          [
            'Code for admins',
            `${admin.code}   valid on this machine until this master exits`,
          ] as const,
        ]),
    ...networkAddresses.map(
      ({ url, kind, interfaceName }, index) =>
        [
          index === 0 ? 'In the network' : '',
          `${url}   ${[KIND_NAMES[kind], interfaceName].filter(Boolean).join(', ')}`,
        ] as const,
    ),
    ...(join === undefined || networkAddresses.length === 0
      ? []
      : [
          ['Code to join', `${join.code}   valid for 12 hours or until this master exits`] as const,
        ]),
    ...(ports.services === ports.main && ports.topicData === ports.main
      ? []
      : [
          [
            'Existing clients',
            `services ${ports.services}, topic data ${ports.topicData}`,
          ] as const,
        ]),
    ...(ports.zeromq === undefined
      ? []
      : [
          [
            'ZeroMQ',
            `services ${ports.zeromq.services}, topic data ${ports.zeromq.topicData}`,
          ] as const,
        ]),
    ['Data', dataDir],
  ];
  const next = [
    ...decided(loopback),
    admin === undefined
      ? `Next: open ${devUrl ?? localUrl} and start an example.`
      : 'Next: open the address for this machine, which makes you admin, and start an example.',
    howPhonesJoin(reachability),
    'Ctrl-C stops the master. All flags:  npm start -- --help',
  ];
  return [
    '',
    `  Ubi-Interact ${version}, master "${name}"`,
    '',
    ...rows.map(([title, text]) => `  ${title.padEnd(20)}${text}`),
    '',
    ...next.map((line) => `  ${line}`),
    '',
  ].join('\n');
}

function howPhonesJoin({ networkAddresses: [best] }: Reachability): string {
  if (best === undefined) {
    return 'Phones cannot reach this master. To connect phones, turn on the local network on the page "Connect a phone", or start the master without --lan off and --host.';
  }
  const open = 'open the address and type the code, or scan the QR code';
  if (best.kind === MasterAddressKind.PUBLIC) return `Phones ${open}.`; // [SV-13]
  const isSecure = best.url.startsWith('https:');
  return `Phones in the same network ${open}${isSecure ? '; they accept the certificate once' : ''}.`;
}

/** Role of callers on this computer without a token. [AC-40] */
function decided({ role, tellsOwners }: LoopbackFacts): readonly string[] {
  const who = tellsOwners
    ? 'Programs and pages of your user on this machine'
    : 'Programs and pages of this machine, of all its users,';
  switch (role) {
    case 'admin':
      return [`${who} are admins without a token (--trust-loopback).`];
    case 'participant':
      return [`${who} are participants; the address and code above make an admin.`];
    case 'none':
      return [`${who} have no access without a token (--loopback none).`];
  }
}
