// @vitest-environment happy-dom
import { createTestClient, FakeMaster, type TestClient } from '@ubii/client-web/testing';
import type { TopicRecord } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { beforeEach, expect, it } from 'vitest';
import { shallowRef, type App } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { CONNECTION } from '../connection/connection.ts';
import { createToasts, provideToasts } from '../ui/toasts/toasts.ts';
import TopicPublisher from './TopicPublisher.vue';

let master: FakeMaster;
let test: TestClient;
beforeEach(async () => {
  master = new FakeMaster();
  test = createTestClient(master);
  await test.client.connect();
});

const recordOf = (format: string, value: unknown) =>
  ({ topic: '/lab/light', clientId: '', timestampMs: 0, format, value }) as TopicRecord;

function open(record: TopicRecord | undefined) {
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/:path*', component: { template: '<p />' } }],
  });
  const connection = {
    client: test.client,
    isConnected: shallowRef(true),
    topics: { watch: () => undefined, rates: shallowRef(undefined) },
    clients: { byId: shallowRef(new Map()) },
  };
  const wrapper = mount(TopicPublisher, {
    props: { topic: '/lab/light', record },
    global: {
      plugins: [router, (app: App) => provideToasts(app, createToasts())],
      provide: { [CONNECTION as symbol]: connection },
    },
  });
  const button = (name: string) => wrapper.findAll('button').find((one) => one.text() === name)!;
  /** Waits for the next frame, in which changes are sent. */
  const published = async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    await test.clock.advance(0);
    return master.published.map(({ topic, value }) => ({ topic, value }));
  };
  return { wrapper, button, published };
}

it('begins with the value of the topic, and publishes each change of a number', async () => {
  const { wrapper, published } = open(recordOf('double', 0.5));
  const input = wrapper.get<HTMLInputElement>('input[inputmode], input[type="number"], input');
  expect(input.element.value).toBe('0.5');
  expect(await published()).toEqual([]);
  await input.setValue('0.75');
  expect(await published()).toEqual([{ topic: '/lab/light', value: 0.75 }]);
});

it('publishes a text when the button is pressed', async () => {
  const { wrapper, button, published } = open(recordOf('string', 'on'));
  await wrapper.get('[aria-label="Value"] :is(input, textarea)').setValue('off');
  expect(await published()).toEqual([]);
  await button('Publish now').trigger('click');
  expect(await published()).toEqual([{ topic: '/lab/light', value: 'off' }]);
});

it('has JSON, variables, snippets and repetition behind More', async () => {
  const { wrapper, button } = open(undefined);
  expect(wrapper.find('[aria-label="Record as JSON"]').exists()).toBe(false);
  expect(wrapper.find('[aria-label="Data format"]').exists()).toBe(true);
  await button('More').trigger('click');
  expect(wrapper.find('[aria-label="Record as JSON"]').exists()).toBe(true);
  expect(wrapper.text()).toContain('Snippets');
  expect(button('Repeat')).toBeDefined();
});
