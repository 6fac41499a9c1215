import type { Random } from '../../random.ts';
import { requireNoServerError, sendAndWaitForEnd } from '../deliver-tcp.ts';
import type { Entrance } from '../entrance.ts';
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
/** As a phone behind a proxy: not a client of this machine. */
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

const TEXTS = [
  'GET / HTTP/1.1\r\nHost: localhost\r\n\r\n',
  'GET /health HTTP/1.1\r\nHost: localhost\r\nAccept: */*\r\n\r\n',
  'GET /metrics HTTP/1.1\r\nHost: localhost\r\nAccept-Encoding: gzip, br\r\n\r\n',
  'GET /ca.json HTTP/1.0\r\n\r\n',
  'HEAD /assets/index.js HTTP/1.1\r\nHost: localhost\r\nRange: bytes=0-10\r\nIf-None-Match: "a"\r\n\r\n',
  'OPTIONS /services/json HTTP/1.1\r\nHost: localhost\r\nOrigin: http://localhost\r\nAccess-Control-Request-Method: POST\r\n\r\n',
  'POST /services/json HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 32\r\n\r\n{"topic":"/services/topic_list"}',
  'POST /services HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n5\r\n{"top\r\n1b\r\nic":"/services/topic_list"}\r\n0\r\n\r\n',
  'POST /services/binary HTTP/1.1\r\nHost: localhost\r\nExpect: 100-continue\r\nContent-Length: 2\r\n\r\n\n\u0000',
  'GET /topicdata?clientID=x HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n',
];

/** Lines that set two readers of HTTP at odds, or ask for more than there is. */
const HEADER_LINES = [
  ...[
    'Content-Length: 5',
    'Content-Length: -1',
    'Content-Length: 99999999999999999999',
    'Content-Length: 5, 5',
  ],
  ...[
    'Transfer-Encoding: chunked',
    'Transfer-Encoding: gzip, chunked',
    'Transfer-Encoding:\tchunked',
    ' folded',
  ],
  ...[
    'Host: a',
    'Host:',
    'Host: [::1',
    'Host: %',
    'Origin: null',
    'Origin: http://[',
    'Forwarded: for="',
    'Via: 1.1 x',
  ],
  ...[
    'X-Forwarded-For: 127.0.0.1',
    'Authorization: Bearer',
    'Authorization: Bearer a.b.c',
    'Cookie: a=%00',
  ],
  ...[
    'Upgrade: websocket',
    'Upgrade: h2c',
    'Connection: Upgrade, close',
    'Sec-WebSocket-Key: a',
    'Expect: x',
  ],
  ...[
    'Sec-WebSocket-Version: 99',
    'Sec-WebSocket-Extensions: permessage-deflate; a="',
    'Range: bytes=-1-',
    'TE: x',
  ],
  ...[
    'Content-Type: application/json; charset=utf-7',
    'Content-Encoding: gzip',
    'Accept-Encoding: *;q=0',
    ': x',
  ],
  ...[
    'If-Modified-Since: x',
    'No colon',
    'A: \u0001',
    `Long: ${'x'.repeat(20_000)}`,
    'Sec-Fetch-Site: cross-site',
  ],
];
const TARGETS = [
  ...[
    '/../../etc/passwd',
    '/%2e%2e/%2e%2e/x',
    '/%',
    '/%00',
    '//',
    '*',
    'http://evil.example/',
    '/?',
    '/a?clientID=',
  ],
  ...[
    '/topicdata?clientID=%ff',
    '/preflight',
    '/preflight?',
    '/services/json/',
    '/services/none',
    '/\\',
    '/ca.pem',
  ],
  ...[
    '/topicdata?clientID=__proto__&token=x',
    `/${'a'.repeat(9_000)}`,
    '/assets/..%2f..%2f',
    '/join',
    '/#x',
    '',
  ],
];
const METHODS = [
  'GET',
  'POST',
  'PUT',
  'DELETE',
  'TRACE',
  'CONNECT',
  'PRI',
  'get',
  'PROPFIND',
  'GET GET',
  '',
];
const VERSIONS = ['HTTP/1.1', 'HTTP/1.0', 'HTTP/2.0', 'HTTP/0.9', 'HTTP/9.9', 'http/1.1', ''];
/** The beginning of a TLS handshake, which the port of HTTPS recognizes by its first byte. */
const TLS_HELLO = Buffer.from('160301020001000001fc0303', 'hex');

/** Request line, headers and framing, on the port as it is. */
export const http: Entrance = {
  name: 'http',
  about: 'HTTP: request line, headers, framing of bodies, upgrades',
  kind: 'running',
  seeds: () => TEXTS.map((text) => new Uint8Array(Buffer.from(text, 'latin1'))),
  mutate: mutateRequest,
  async deliver(input, { master }) {
    requireNoServerError(await sendAndWaitForEnd(master.port, input));
  },
};

function mutateRequest(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array {
  if (random.oneIn(3)) return mutateBytes(random, seed, other);
  if (random.oneIn(60)) return Buffer.concat([TLS_HELLO, random.bytes(random.below(600))]);
  const text = Buffer.from(seed).toString('latin1');
  const [head = '', body = ''] = text.split(/\r\n\r\n(.*)/s);
  const lines = head.split('\r\n');
  const [method, target, version] = (lines[0] ?? '').split(' ');
  const line = [
    random.oneIn(5) ? random.pick(METHODS) : method,
    random.oneIn(3) ? random.pick(TARGETS) : target,
    random.oneIn(8) ? random.pick(VERSIONS) : version,
  ].join(random.oneIn(30) ? '\t' : ' ');
  const headers = lines.slice(1);
  const added = random.oneIn(25) ? 3_000 : random.below(4);
  for (let i = 0; i < added; i++) {
    headers.splice(
      random.below(headers.length + 1),
      0,
      random.pick(HEADER_LINES.slice(0, added > 9 ? 8 : undefined)),
    );
  }
  const end = random.oneIn(15) ? '\n' : '\r\n';
  const whole = [line, ...headers, '', body].join(end);
  const request = Buffer.from(whole, 'latin1');
  // Several in one go, the second perhaps hidden in the body of the first.
  return random.oneIn(6) ? Buffer.concat([request, other]) : request;
}
