import {
  DATA_FORMATS,
  fromJson,
  messageDescriptor,
  type DataFormat,
  type FieldDescriptor,
  type JsonObject,
  type JsonValue,
  type TopicDataRecord,
  type TopicRecord,
} from '@ubii/proto';
import { expect, test, type Room } from '../../fixtures/test.ts';
import { PublishPage } from '../../pages/publish-page.ts';
import { Shell } from '../../pages/shell.ts';

const FORMATS = Object.keys(DATA_FORMATS) as DataFormat[];
const RECORD = 'ubii.topicData.TopicDataRecord';
/** Messages within messages are filled to this depth; sessions and devices would be books. */
const DEPTH = { system: 2, others: 4 } as const;

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

const fieldOf = (format: DataFormat): FieldDescriptor =>
  messageDescriptor(RECORD).fieldByName.get(format)!;
const valueOf = (json: string, format: DataFormat): unknown =>
  (fromJson(RECORD, JSON.parse(json)) as TopicDataRecord)[format];

async function enter(room: Room) {
  const robot = await room.program('Robot');
  const records = new Map<string, TopicRecord>();
  const subscription = robot.subscribe({ glob: '/made/**' });
  subscription.onRecord((record) => records.set(record.topic, record));
  await subscription.ready;
  const publish = new PublishPage(await room.atDesk());
  await publish.open();
  await new Shell(publish.page).expectConnected();
  const expectReceived = async (topic: string, format: DataFormat): Promise<void> => {
    const expected = valueOf(await publish.json.inputValue(), format);
    await publish.publish();
    await expect.poll(() => records.get(topic)?.format).toBe(format);
    expect(records.get(topic)?.value, topic).toEqual(expected);
  };
  return { publish, expectReceived };
}

test('every data format arrives as its form says, with a number typed where there is one', async ({
  room,
}) => {
  test.slow();
  const { publish, expectReceived } = await enter(room);
  for (const format of FORMATS) {
    await test.step(format, async () => {
      await publish.topic.fill(`/made/${format}`);
      if (format !== 'double') await publish.choose(format);
      await expect(publish.json).toHaveValue(new RegExp(`"${format}"`));
      const { type } = fieldOf(format);
      const fields = typeof type === 'object' && type.kind === 'message' ? type.fields : [];
      const number =
        typeof type === 'string'
          ? fieldOf(format)
          : fields.find(
              (field) =>
                !field.repeated &&
                field.oneof === undefined &&
                (field.type === 'double' || field.type === 'string'),
            );
      if (number && number.type !== 'bool') {
        const typed = number.type === 'string' ? 'typed' : '3';
        await publish.field(number.jsonName).first().fill(typed);
        const written = number.type === 'string' ? '"typed"' : '3';
        await expect(publish.json).toHaveValue(new RegExp(`"${number.jsonName}": ${written}`));
      }
      await expectReceived(`/made/${format}`, format);
    });
  }
});

test('every data format arrives as its JSON says, with every member filled in', async ({
  room,
}) => {
  test.slow();
  const { publish, expectReceived } = await enter(room);
  for (const format of FORMATS) {
    await test.step(format, async () => {
      const topic = `/made/json/${format}`;
      const isSystem = DATA_FORMATS[format].family === 'system';
      const value = sample(fieldOf(format), isSystem ? DEPTH.system : DEPTH.others);
      await publish.json.fill(JSON.stringify({ topic, [format]: value }, null, 2));
      await expect(publish.topic).toHaveValue(topic);
      await expectReceived(topic, format);
    });
  }
});

test('a value of the wrong kind is refused beside its field, for every data format', async ({
  room,
}) => {
  test.slow();
  const { publish } = await enter(room);
  for (const format of FORMATS) {
    await test.step(format, async () => {
      const { type } = fieldOf(format);
      // A number is a text, too: what is none is not.
      const wrong = typeof type === 'object' || type === 'string' ? 5 : 'up';
      const bad = type === 'string' ? { a: 1 } : wrong;
      await publish.json.fill(JSON.stringify({ topic: `/made/${format}`, [format]: bad }));
      await expect(publish.form.getByRole('alert').first()).toBeVisible();
      await expect(publish.page.getByRole('button', { name: /^Line 1 / }).first()).toBeVisible();
      await publish.expectBlocked(new RegExp(`^${format}`));
    });
  }
  await expect(publish.sent).toContainText('0');
});
