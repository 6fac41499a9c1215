// @vitest-environment happy-dom
import { afterEach, expect, it, vi } from 'vitest';
import { effectScope } from 'vue';
import { removeOnPageHide } from './remove-on-page-hide.ts';

const scope = effectScope();
afterEach(() => vi.unstubAllGlobals());

it('removes the session of a page that is closed, and none while there is none', async () => {
  const sent: [string, Blob][] = [];
  vi.stubGlobal('navigator', {
    sendBeacon: (path: string, body: Blob) => sent.push([path, body]) > 0,
  });
  const shown: { id?: string } = {};
  scope.run(() => removeOnPageHide(() => shown.id));
  window.dispatchEvent(new Event('pagehide'));
  expect(sent).toEqual([]);
  shown.id = 's1';
  window.dispatchEvent(new Event('pagehide'));
  expect(sent.map(([path]) => path)).toEqual(['/services/json']);
  expect(JSON.parse(await sent[0]![1].text())).toMatchObject({
    topic: '/services/session/runtime/remove',
    session: { id: 's1' },
  });
  scope.stop();
  window.dispatchEvent(new Event('pagehide'));
  expect(sent).toHaveLength(1);
});
