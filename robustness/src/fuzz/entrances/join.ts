import { requireNoServerError, sendAndWaitForEnd } from '../deliver-tcp.ts';
import type { Entrance } from '../entrance.ts';
import type { Random } from '../../random.ts';
import { mutateBytes } from '../mutate-bytes.ts';
import { mutateJson } from '../mutate-json.ts';

const CHECK = '{"topic":"/services/ubii/join_check","joinCheckRequest":{"token":"K7QF-2MXR"}}';
const REGISTER =
  '{"topic":"/services/client/registration","client":{"name":"phone","extension":{}}}';
const BEARERS = [
  ...[
    'Bearer K7QF-2MXR',
    'Bearer k7qf2mxr',
    'Bearer ',
    'Bearer',
    'bearer x',
    'Basic YTpi',
    'Bearer a.b.c.d',
  ],
  `Bearer ${'A'.repeat(43)}`,
  `Bearer ${Buffer.from('{"c":"x","g":"y","e":1}').toString('base64url')}.${'A'.repeat(43)}`,
];
/** As a phone behind a proxy: nobody this machine knows. */
const STRANGER = 'X-Forwarded-For: 198.51.100.7';

/** Requests of callers without a role: bearer tokens and join credentials. */
export const join: Entrance = {
  name: 'join',
  about: 'tokens, codes and credentials of strangers: headers and join_check',
  kind: 'running',
  seeds: () =>
    BEARERS.flatMap((bearer) => [CHECK, REGISTER].map((body) => Buffer.from(`${bearer}\n${body}`))),
  mutate(random: Random, seed, other) {
    if (random.oneIn(2)) return mutateBytes(random, seed, other);
    const [bearer = '', body = ''] = Buffer.from(seed).toString().split('\n');
    const changed = JSON.stringify(mutateJson(random, JSON.parse(body)));
    const token = random.oneIn(2)
      ? bearer
      : Buffer.from(mutateBytes(random, Buffer.from(bearer), other)).toString('latin1');
    return Buffer.from(`${token.replaceAll('\n', '')}\n${changed}`, 'latin1');
  },
  async deliver(input, { master }) {
    const text = Buffer.from(input).toString('latin1');
    const at = text.indexOf('\n');
    const bearer = text.slice(0, at < 0 ? undefined : at);
    const body = at < 0 ? '' : text.slice(at + 1);
    const head = [
      ...['POST /services/json HTTP/1.1', 'Host: localhost', 'Connection: close', STRANGER],
      ...[
        'Content-Type: application/json',
        `Authorization: ${bearer}`,
        `Content-Length: ${body.length}`,
      ],
    ];
    const request = Buffer.from(`${head.join('\r\n')}\r\n\r\n${body}`, 'latin1');
    requireNoServerError(await sendAndWaitForEnd(master.port, request));
  },
};
