// Client of the test network: sends one request or upgrade, given as JSON in the first argument.
import { request as requestHttp } from 'node:http';
import { request as requestHttps } from 'node:https';

const {
  url,
  method = 'GET',
  headers = {},
  body,
  from,
  upgrade = false,
} = JSON.parse(process.argv[2] ?? '');
const send = url.startsWith('https:') ? requestHttps : requestHttp;
const outgoing = send(url, {
  method,
  localAddress: from,
  // The certificate is tested elsewhere.
  rejectUnauthorized: false,
  headers: upgrade
    ? {
        connection: 'Upgrade',
        upgrade: 'websocket',
        'sec-websocket-version': '13',
        'sec-websocket-key': 'AAAAAAAAAAAAAAAAAAAAAA==',
        ...headers,
      }
    : headers,
});
const tell = (status, text) => {
  process.stdout.write(JSON.stringify({ status, text }));
  process.exit(0);
};
outgoing.on('upgrade', (response) => tell(response.statusCode, ''));
outgoing.on('response', (response) => {
  let text = '';
  response.on('data', (chunk) => (text += chunk));
  response.on('end', () => tell(response.statusCode, text));
});
outgoing.on('error', (error) => tell(0, error.message));
outgoing.setTimeout(10_000, () => tell(0, 'no answer'));
outgoing.end(body);
