// @vitest-environment happy-dom
import { RecordingKind, type Recording } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { afterEach, describe, expect, it } from 'vitest';
import { computed, type App } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { CONNECTION } from '../../connection/connection.ts';
import { createToasts, provideToasts } from '../../ui/toasts/toasts.ts';
import RecordingStrip from './RecordingStrip.vue';

const wrappers: { unmount(): void }[] = [];
afterEach(() => wrappers.splice(0).forEach((wrapper) => wrapper.unmount()));

async function open(path: string, running: readonly Partial<Recording>[]): Promise<string> {
  const page = { template: '<p />' };
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/recordings/:recording?', component: page }],
  });
  await router.push(path);
  const client = { role: 'admin' };
  const connection = { client, state: computed(() => ({ status: 'connected' })) };
  const wrapper = mount(RecordingStrip, {
    props: { running: running as readonly Recording[] },
    global: {
      plugins: [router, (app: App) => provideToasts(app, createToasts())],
      provide: { [CONNECTION as symbol]: connection },
    },
  });
  wrappers.push(wrapper);
  return wrapper.text();
}

describe('the strip about recordings', () => {
  const lesson = { id: 'a', name: 'Lesson', durationMs: 1000 };
  const run = { id: 'b', name: 'Run', durationMs: 1000 };
  const comparison = { ...run, kind: RecordingKind.RECORDING_KIND_COMPARISON };

  it('is on all pages but that of the recording', async () => {
    expect(await open('/recordings', [lesson])).toContain('Recording Lesson');
    expect(await open('/recordings/a', [lesson])).toBe('');
  });

  it('does not tell of a session that runs again', async () => {
    expect(await open('/recordings', [comparison])).toBe('');
    expect(await open('/recordings', [comparison, lesson])).not.toContain('other recording');
  });
});
