import { MasterAddressKind } from '@ubii/proto';

import type { ListeningPorts } from '../network/listeners.ts';
import type { Reachability } from '../network/reachability.ts';

export interface BannerFacts {
  readonly name: string;
  readonly version: string;
  readonly dataDir: string;
  readonly ports: ListeningPorts;
  readonly reachability: Reachability;
  /** What others join with; undefined when only this machine reaches the master. */
  readonly join: { readonly token: string; readonly code: string } | undefined;
  /** Address of the development server that serves the pages instead of the master. */
  readonly devUrl: string | undefined;
}

const KIND_NAMES: Readonly<Record<number, string>> = {
  [MasterAddressKind.WIFI]: 'Wi-Fi',
  [MasterAddressKind.ETHERNET]: 'Ethernet',
  [MasterAddressKind.VIRTUAL]: 'virtual network',
};

/** The address a phone should be given: the best one that is not of a virtual network. */
export function bestPhoneUrl({ networkAddresses }: Reachability): string | undefined {
  const real = networkAddresses.find(({ kind }) => kind !== MasterAddressKind.VIRTUAL);
  return (real ?? networkAddresses[0])?.url;
}

/** What a phone opens to join: the token stands where nothing is sent to anybody. [AC-11] */
export function joinUrl(origin: string, token: string): string {
  return `${origin}/join#${token}`;
}

/** What a person who started the master reads: where it is, and what to do next. */
export function formatBanner(facts: BannerFacts): string {
  const { name, version, dataDir, ports, reachability, join, devUrl } = facts;
  const { localUrl, networkAddresses } = reachability;
  const rows: (readonly [string, string])[] = [
    ...(devUrl === undefined ? [] : [['Pages (hot reload)', devUrl] as const]),
    ['On this machine', localUrl],
    ...networkAddresses.map(
      ({ url, kind, interfaceName }, index) =>
        [
          index === 0 ? 'In the network' : '',
          `${url}   ${KIND_NAMES[kind]}, ${interfaceName}`,
        ] as const,
    ),
    ...(join === undefined || networkAddresses.length === 0
      ? []
      : [['Code to join', `${join.code}   good for 12 hours, until this master ends`] as const]),
    ...(ports.services === ports.main && ports.topicData === ports.main
      ? []
      : [
          [
            'Existing clients',
            `services ${ports.services}, topic data ${ports.topicData}`,
          ] as const,
        ]),
    ['Data', dataDir],
  ];
  const openUrl = devUrl ?? localUrl;
  const next = [
    `Next: open ${openUrl} in two browsers and choose the mouse-pointer example.`,
    networkAddresses.length > 0
      ? networkAddresses[0]?.url.startsWith('https:')
        ? 'Phones in the same network open the address and type the code, or scan the QR code; they accept the certificate once.'
        : 'Phones in the same network open the address and type the code, or scan the QR code.'
      : 'Phones cannot reach this master: to let them in, end it and start it without --lan off and --host.',
    'Ctrl-C ends the master. All flags:  npm start -- --help',
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
