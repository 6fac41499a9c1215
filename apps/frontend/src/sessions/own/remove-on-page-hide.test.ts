// @vitest-environment happy-dom
import { afterEach, expect, it, vi } from 'vitest';
import { effectScope } from 'vue';
import { removeOnPageHide } from './remove-on-page-hide.ts';

const REMOVAL = { topic: '/services/session/runtime/remove', session: { id: 's1' } };
const client = { authorization: 'Bearer credential' };
afterEach(() => vi.unstubAllGlobals());

it('removes the session of a page that is closed, as its client, and none while there is none', () => {
  const fetch = vi.fn<typeof globalThis.fetch>(() => Promise.reject(new Error('closed')));
  vi.stubGlobal('fetch', fetch);
  vi.stubGlobal('Request', { prototype: { keepalive: false } });
  const scope = effectScope();
  const shown: { id?: string } = {};
  scope.run(() => removeOnPageHide(client, () => shown.id));
  window.dispatchEvent(new Event('pagehide'));
  expect(fetch).not.toHaveBeenCalled();
  shown.id = 's1';
  window.dispatchEvent(new Event('pagehide'));
  const [path, init] = fetch.mock.lastCall!;
  expect(path).toBe('/services/json');
  expect(init).toMatchObject({
    method: 'POST',
    keepalive: true,
    headers: { Authorization: 'Bearer credential' },
  });
  expect(JSON.parse(init!.body as string)).toMatchObject(REMOVAL);
  scope.stop();
  window.dispatchEvent(new Event('pagehide'));
  expect(fetch).toHaveBeenCalledOnce();
});

it('sends a beacon from browsers whose requests end with the page', async () => {
  const sent: Blob[] = [];
  vi.stubGlobal('Request', { prototype: {} });
  vi.stubGlobal('navigator', { sendBeacon: (_path: string, body: Blob) => sent.push(body) > 0 });
  const scope = effectScope();
  scope.run(() => removeOnPageHide(client, () => 's1'));
  window.dispatchEvent(new Event('pagehide'));
  scope.stop();
  expect(JSON.parse(await sent[0]!.text())).toMatchObject(REMOVAL);
});
