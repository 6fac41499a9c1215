// @vitest-environment happy-dom
import { createTestClient, FakeMaster, type TestClient } from '@ubii/client-web/testing';
import {
  DATA_FORMATS,
  fromJson,
  type DataFormat,
  type FieldDescriptor,
  type JsonObject,
  type JsonValue,
  type TopicDataRecord,
} from '@ubii/proto';
import { mount, type VueWrapper } from '@vue/test-utils';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { nextTick, shallowRef, type App } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { CONNECTION } from '../connection/connection.ts';
import { createShell, SHELL } from '../page/shell.ts';
import { createToasts, provideToasts } from '../ui/toasts/toasts.ts';
import PublishBar from './PublishBar.vue';
import PublishPage from './PublishPage.vue';
import { recordField } from './record-json.ts';

const FORMATS = Object.keys(DATA_FORMATS) as DataFormat[];
/** Messages within messages are filled to this depth; sessions and devices would be books. */
const DEPTH = { system: 2, others: 4 } as const;

let master: FakeMaster;
let clock: TestClient['clock'];
let page: VueWrapper;
const shell = createShell();

// One page for all formats, as its user has: what was typed for one must not stay for the next.
beforeAll(async () => {
  master = new FakeMaster();
  const test = createTestClient(master);
  const { client } = test;
  clock = test.clock;
  await client.connect();
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/:path*', component: { template: '<p />' } }],
  });
  await router.push('/publish');
  const connection = {
    client,
    isConnected: shallowRef(true),
    topics: { watch: () => undefined, rates: shallowRef(undefined) },
    clients: { byId: shallowRef(new Map()) },
  };
  page = mount(PublishPage, {
    attachTo: document.body,
    global: {
      plugins: [router, (app: App) => provideToasts(app, createToasts())],
      provide: { [CONNECTION as symbol]: connection, [SHELL as symbol]: shell },
    },
  });
});
afterAll(() => page.unmount());

const json = () => page.get<HTMLTextAreaElement>('[aria-label="Record as JSON"]');
const form = () => page.get('[aria-label="Form"]');
const button = (name: string) => page.findAll('button').find((one) => one.text() === name)!;
const fieldsOf = (format: DataFormat): readonly FieldDescriptor[] => {
  const { type } = recordField(format);
  return typeof type === 'object' && type.kind === 'message' ? type.fields : [];
};

async function chooseFormat(format: DataFormat): Promise<void> {
  page.getComponent(PublishBar).vm.$emit('update:format', format);
  await nextTick();
}

/** Presses the button; the master gets what the JSON says. */
async function expectPublished(topic: string, format: DataFormat): Promise<void> {
  const record = fromJson('ubii.topicData.TopicDataRecord', JSON.parse(json().element.value));
  master.published.length = 0;
  await button('Publish').trigger('click');
  await clock.advance(0);
  expect(master.published).toMatchObject([{ topic, format }]);
  expect(master.published[0]!.value).toEqual((record as TopicDataRecord)[format]);
}

/** A value no member of which is what it would be anyway. */
function sample({ type, jsonName }: FieldDescriptor, most: number, depth = 0): JsonValue {
  if (typeof type === 'object') {
    if (type.kind === 'enum') return [...type.nameByNumber.values()].at(-1)!;
    const oneofs = new Set<string>();
    const members = type.fields.flatMap((field) => {
      const isInner = typeof field.type === 'object' && field.type.kind === 'message';
      if (field.number >= 1000 || (isInner && depth >= most)) return [];
      if (field.oneof !== undefined && oneofs.has(field.oneof)) return [];
      if (field.oneof !== undefined) oneofs.add(field.oneof);
      const value = sample(field, most, depth + 1);
      return [
        [field.jsonName, field.repeated ? Array(depth === 0 ? 2 : 1).fill(value) : value] as const,
      ];
    });
    const object = Object.fromEntries(members) as JsonObject;
    // One brightness of one pixel is a picture.
    if (type.name.endsWith('.Image2D'))
      Object.assign(object, { width: 1, height: 1, dataFormat: 'GRAY8', data: 'Bw==' });
    return object;
  }
  if (type === 'bool') return true;
  if (type === 'string') return `a ${jsonName}`;
  if (type === 'bytes') return 'Bw==';
  if (type === 'int64') return '7';
  return type === 'double' || type === 'float' ? 0.25 : 3;
}

it('tells the shell its heading, which the path in the top bar does not repeat', () => {
  expect(shell.pageHeading.value).toBe(page.get('h1').text());
});

describe.each(FORMATS)('the publish page, with %s', (format) => {
  it('publishes what its form says, with a number or text typed where there is one', async () => {
    await page.get('input[placeholder="/lab/light"]').setValue('/made');
    await page.get('input[placeholder="/lab/light"]').trigger('focusout');
    await chooseFormat(format);
    expect(json().element.value).toContain(`"${format}"`);
    const isTyped = ({ type }: FieldDescriptor) => type === 'double' || type === 'string';
    const whole = recordField(format);
    const field = isTyped(whole)
      ? whole
      : fieldsOf(format).find((one) => !one.repeated && one.oneof === undefined && isTyped(one));
    if (field) {
      const label = form()
        .findAll('label')
        .find((one) => one.text() === field.jsonName)!;
      const input = form().get(`[id="${label.attributes('for')}"]`);
      await input.setValue(field.type === 'string' ? 'typed' : '3');
      const written = field.type === 'string' ? '"typed"' : '3';
      expect(json().element.value).toContain(`"${field.jsonName}": ${written}`);
    }
    await expectPublished('/made', format);
  });

  it('publishes what its JSON says, with every member filled in', async () => {
    const most = DATA_FORMATS[format].family === 'system' ? DEPTH.system : DEPTH.others;
    const value = sample(recordField(format), most);
    await json().setValue(JSON.stringify({ topic: '/made/json', [format]: value }));
    await expectPublished('/made/json', format);
  });

  it('refuses a value of the wrong kind beside its field', async () => {
    const { type } = recordField(format);
    // A number is a text, too: what is none is not.
    const bad = type === 'string' ? { a: 1 } : typeof type === 'object' ? 5 : 'up';
    await json().setValue(JSON.stringify({ topic: '/made', [format]: bad }));
    expect(form().find('[role="alert"]').exists()).toBe(true);
    expect(page.findAll('button').some((one) => one.text().startsWith('Line 1'))).toBe(true);
    expect(button('Publish').attributes('aria-disabled')).toBe('true');
    expect(button('Publish').attributes('aria-description')).toMatch(new RegExp(`^${format}`));
    master.published.length = 0;
    await button('Publish').trigger('click');
    await clock.advance(0);
    expect(master.published).toEqual([]);
  });
});
