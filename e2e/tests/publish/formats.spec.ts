import {
  fromJson,
  type DataFormat,
  type JsonObject,
  type TopicDataRecord,
  type TopicRecord,
} from '@ubii/proto';
import { expect, test } from '../../fixtures/test.ts';
import { PublishPage } from '../../pages/publish-page.ts';
import { Shell } from '../../pages/shell.ts';

/**
 * Data formats of a number, a text, a message, messages with an enumeration, and a list, with a field to type into where
 * there is one. All formats with all their members are published in `PublishPage.test.ts`.
 */
const KINDS: readonly (readonly [DataFormat, string?])[] = [
  ['double', 'double'],
  ['string', 'string'],
  ['vector2', 'x'],
  ['touchEvent'],
  ['object3DList'],
];
const SESSION: JsonObject = {
  id: 'the-one',
  name: 'Mirror',
  tags: ['a', 'b'],
  processingModules: [
    { name: 'mirror', inputs: [{ internalName: 'in', messageFormat: 'vector2' }] },
  ],
  ioMappings: [
    {
      processingModuleName: 'mirror',
      inputMappings: [{ inputName: 'in', topicMux: { topicSelector: '/.*/point' } }],
      outputMappings: [{ outputName: 'out', topic: '/mirrored' }],
    },
  ],
};

test('a record of each kind arrives as its form and as its JSON says', async ({ room }) => {
  const robot = await room.program('Robot');
  const records = new Map<string, TopicRecord>();
  const subscription = robot.subscribe({ glob: '/made/**' });
  subscription.onRecord((record) => records.set(record.topic, record));
  await subscription.ready;
  const publish = new PublishPage(await room.atDesk());
  await publish.open();
  await new Shell(publish.page).expectConnected();
  const expectReceived = async (topic: string, format: DataFormat): Promise<void> => {
    const json = JSON.parse(await publish.json.inputValue());
    const expected = fromJson('ubii.topicData.TopicDataRecord', json) as TopicDataRecord;
    await publish.publish();
    await expect.poll(() => records.get(topic)?.format).toBe(format);
    expect(records.get(topic)?.value).toEqual(expected[format]);
  };

  for (const [format, field] of KINDS) {
    await test.step(`${format} as its form says`, async () => {
      await publish.topic.fill(`/made/${format}`);
      if (format !== 'double') await publish.choose(format);
      await expect(publish.json).toHaveValue(new RegExp(`"${format}"`));
      if (field !== undefined) {
        await publish.field(field).first().fill('3');
        await expect(publish.json).toHaveValue(new RegExp(`"${field}": "?3"?`));
      }
      await expectReceived(`/made/${format}`, format);
    });
  }

  await test.step('a session as its JSON says', async () => {
    await publish.json.fill(JSON.stringify({ topic: '/made/json', session: SESSION }));
    await expect(publish.topic).toHaveValue('/made/json');
    await expectReceived('/made/json', 'session');
    expect(records.get('/made/json')?.value).toMatchObject({ name: 'Mirror', tags: ['a', 'b'] });
  });
});
