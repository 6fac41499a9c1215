import { describe, expect, it } from 'vitest';
import { callerBehind, isPassedOn } from './forwarding.ts';

describe('headers of proxies', () => {
  it.each([
    'forwarded',
    'x-forwarded-for',
    'x-forwarded-host',
    'x-forwarded-proto',
    'x-forwarded-tls-client-cert',
    'x-original-forwarded-for',
    'x-original-url',
    'x-original-host',
    'x-real-ip',
    'x-client-ip',
    'client-ip',
    'true-client-ip',
    'x-true-client-ip',
    'x-cluster-client-ip',
    'x-azure-clientip',
    'fastly-client-ip',
    'fly-client-ip',
    'cf-connecting-ip',
    'cf-connecting-ipv6',
    'cf-ray',
    'cdn-loop',
    'x-envoy-external-address',
    'x-envoy-expected-rq-timeout-ms',
    'x-amzn-trace-id',
    'x-amz-cf-id',
    'x-arr-ssl',
    'x-varnish',
    'x-remote-addr',
    'remote-user',
    'x-proxy-user-ip',
    'proxy-authorization',
    'tailscale-user-login',
    'ngrok-skip-browser-warning',
    'x-peer-ip',
    'x-source-address',
    'via',
    'x-client-port',
    'x-nginx-proxy',
    'x-proxyuser-ip',
    'x-ms-proxy',
    'x-ms-client-principal',
    'front-end-https',
    'x-ssl-client-cert',
    'ssl-client-verify',
    'client-cert-chain',
    // Clients send it to a proxy; those that pass on what they get send nothing else that tells them.
    'proxy-connection',
    'x-coder-session',
    'x-github-token',
    // Not invented yet.
    'x-some-new-tunnel-forwarded-client',
    'some-new-proxy-session',
  ])('%s is one [AC-1]', (name) => {
    expect(isPassedOn({ host: 'localhost', [name]: '' })).toBe(true);
  });

  it('has no name of what browsers, existing clients and programs send [AC-1]', () => {
    const names = [
      ...['host', 'connection', 'https', 'user-agent', 'accept', 'accept-encoding'],
      ...['accept-language', 'content-type', 'content-length', 'origin', 'referer', 'cookie'],
      ...['authorization', 'cache-control', 'pragma', 'dnt', 'sec-gpc', 'sec-fetch-site'],
      ...['sec-fetch-mode', 'sec-fetch-dest', 'sec-ch-ua', 'sec-ch-ua-platform', 'priority'],
      ...['upgrade', 'upgrade-insecure-requests', 'sec-websocket-key', 'sec-websocket-version'],
      ...['sec-websocket-extensions', 'sec-websocket-protocol', 'x-requested-with', 'te'],
      ...['transfer-encoding', 'if-none-match', 'range', 'purpose', 'sec-purpose', 'expect'],
      ...['x-request-id', 'x-client-version', 'x-user-agent', 'traceparent', 'client-id'],
      ...['x-frontend-version', 'x-client-name', 'x-user-id', 'x-csrf-token', 'keep-alive'],
    ];
    expect(names.filter((name) => isPassedOn({ [name]: 'x' }))).toEqual([]);
  });
});

describe('the client that a trusted proxy names', () => {
  const isTrusted = (address: string) => address.startsWith('10.0.0.');

  it.each([
    ['203.0.113.7', '203.0.113.7'],
    ['203.0.113.7, 10.0.0.2', '203.0.113.7'],
    // The stranger wrote the first two.
    ['127.0.0.1, 192.168.1.5, 203.0.113.7', '203.0.113.7'],
    ['203.0.113.7:4711', '203.0.113.7'],
    ['2001:db8::7', '2001:db8::7'],
    ['[2001:db8::7]:4711', '2001:db8::7'],
    ['::ffff:203.0.113.7', '203.0.113.7'],
    ['127.0.0.1', '127.0.0.1'],
    ['203.0.113.7, unknown', undefined],
    ['203.0.113.7, ', undefined],
    ['203.0.113.7 10.0.0.2', undefined],
    ['localhost', undefined],
    ['', undefined],
    // Only proxies.
    ['10.0.0.3, 10.0.0.2', undefined],
    [Array(40).fill('10.0.0.3').join(','), undefined],
  ])('X-Forwarded-For: %s is %s [AC-41]', (list, caller) => {
    expect(callerBehind({ 'x-forwarded-for': list }, isTrusted)).toBe(caller);
  });

  it.each([
    ['for=203.0.113.7', '203.0.113.7'],
    ['for=127.0.0.1, For="203.0.113.7:4711";proto=http;by=10.0.0.2', '203.0.113.7'],
    ['for="[2001:db8::7]:4711"', '2001:db8::7'],
    ['proto=http', undefined],
    ['for=203.0.113.7, for=_hidden', undefined],
    ['for=203.0.113.7;for=127.0.0.1', undefined],
  ])('Forwarded: %s is %s [AC-41]', (forwarded, caller) => {
    expect(callerBehind({ forwarded }, isTrusted)).toBe(caller);
  });

  it('is undefined with two headers, because the caller may have set one of them [AC-41]', () => {
    const headers = { forwarded: 'for=10.1.1.1', 'x-forwarded-for': '203.0.113.7' };
    expect(callerBehind(headers, isTrusted)).toBeUndefined();
    expect(callerBehind({ via: '1.1 proxy' }, isTrusted)).toBeUndefined();
  });
});
