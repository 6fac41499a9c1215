import { moduleLibrary } from '@ubii/modules';
import { parseMode } from '@ubii/pm-sandbox';
import {
  DATA_FORMATS,
  parseDataFormat,
  SERVICES,
  type DataFormat,
  type ServiceName,
} from '@ubii/proto';
import { reference } from 'virtual:learn-reference';
import { capitalised } from '@ubii/words';

/** Entry of the reference: one row of a page, one search result. */
export interface ReferenceEntry {
  /** Displayed, and used in the URL after `#`. */
  readonly name: string;
  readonly sentence: string;
  /** Short facts as label and value. Identifiers in back-quotes. */
  readonly facts: readonly (readonly [label: string, value: string])[];
  /** Members of a message, inputs and outputs of a module. */
  readonly fields?: readonly {
    readonly name: string;
    readonly type: string;
    readonly sentence: string;
  }[];
  /** Data format whose socket is shown before the name. */
  readonly format?: DataFormat;
}

export interface ReferenceSection {
  readonly title: string;
  readonly entries: readonly ReferenceEntry[];
}

export interface ReferencePage {
  /** Part of the URL. */
  readonly id: string;
  readonly title: string;
  readonly intro: string;
  readonly sections: readonly ReferenceSection[];
}

const { messages } = reference;
const RECORD_FIELDS = messages['ubii.topicData.TopicDataRecord']?.fields ?? {};

const code = (text: string): string => `\`${text}\``;
const roleWords = (roles: readonly string[] | 'anyone'): string => {
  if (roles === 'anyone') return 'every caller';
  return roles.length === 0 ? 'no role' : roles.join(', ');
};
/** Removes rule ids, which are for developers of the master. */
const withoutRules = (text: string): string =>
  text
    .replace(/\s*[([]?\b(?:Rules? )?[A-Z]{2}-\d+(?:(?:, | and )[A-Z]{2}-\d+)*[)\]]?\.?/g, '')
    .trim();

function fieldsOf(message: string): NonNullable<ReferenceEntry['fields']> {
  return Object.entries(messages[message]?.fields ?? {}).map(([name, { comment, type }]) => ({
    name,
    type: type.replace(/ubii\.(\w+\.)*/, '').replace('repeated ', 'list of '),
    sentence: withoutRules(comment),
  }));
}

function messageEntry(name: string): ReferenceEntry {
  return {
    name: name.split('.').at(-1) ?? name,
    sentence: withoutRules(messages[name]?.comment ?? ''),
    facts: [['Message', code(name)]],
    fields: fieldsOf(name),
  };
}

/** Groups entries by heading, in the order of first occurrence. */
function sections(
  entries: readonly (readonly [head: string, entry: ReferenceEntry])[],
): ReferenceSection[] {
  const byHead = new Map<string, ReferenceEntry[]>();
  for (const [head, entry] of entries) byHead.set(head, [...(byHead.get(head) ?? []), entry]);
  return [...byHead].map(([head, list]) => ({ title: capitalised(head), entries: list }));
}

function formats(): ReferencePage {
  const entries = (Object.keys(DATA_FORMATS) as DataFormat[]).map((format) => {
    const { family, messageType, fieldNumber, isList, isEvent } = DATA_FORMATS[format];
    const described = RECORD_FIELDS[format]?.comment ?? messages[messageType]?.comment ?? '';
    const entry: ReferenceEntry = {
      name: format,
      sentence: withoutRules(described),
      facts: [
        ['Type', code(messageType)],
        ['Field of a record', String(fieldNumber)],
        ...(isList ? [['Holds', 'a list'] as const] : []),
        ...(isEvent ? [['Delivery', 'every record, not only the newest'] as const] : []),
      ],
      fields: fieldsOf(messageType),
      format,
    };
    return [family, entry] as const;
  });
  return {
    id: 'data-formats',
    title: 'Data formats',
    intro:
      'The format of a record determines its value. Formats of one family share a colour and a socket.',
    sections: sections(entries),
  };
}

function services(): ReferencePage {
  const entries = (Object.keys(SERVICES) as ServiceName[]).map((name) => {
    const { topic, description, requestFormat, replyFormat, requestRequired, isExtension } =
      SERVICES[name];
    const rights = reference.serviceRights[name];
    const path = topic.replace('/services/', '');
    const group = path.includes('/') ? (path.split('/')[0] ?? '') : 'master';
    const request = requestFormat === '' ? 'none' : code(requestFormat);
    const entry: ReferenceEntry = {
      name: path,
      sentence: description,
      facts: [
        ['Topic', code(topic)],
        ['Request', requestFormat !== '' && !requestRequired ? `${request}, optional` : request],
        ['Reply', code(replyFormat)],
        ...(rights === undefined
          ? [['Offered by', 'original masters, not this one'] as const]
          : [['Allowed for', roleWords(rights.roles)] as const]),
        ...(rights?.audited ? [['Audit log', 'every call'] as const] : []),
        ...(isExtension ? [['Offered by', 'this master, not by original ones'] as const] : []),
      ],
    };
    return [group.replaceAll('_', ' '), entry] as const;
  });
  return {
    id: 'services',
    title: 'Services',
    intro:
      'A service is one request and one reply over HTTP. The role of a client follows from its invitation.',
    sections: sections(entries),
  };
}

function modeWords(mode: ReturnType<typeof parseMode>): string {
  switch (mode.kind) {
    case 'frequency':
      return `${mode.hertz} times a second`;
    case 'trigger':
      return mode.allInputsNeedUpdate
        ? 'when all inputs have new values'
        : 'when an input has a new value';
    case 'lockstep':
      return 'in lockstep with its session';
    case 'free':
      return 'again as soon as it has finished';
  }
}

function modules(): ReferencePage {
  const formatOf = (format: string): string =>
    format === '' ? 'any format' : code(parseDataFormat(format) ?? format);
  const entries = moduleLibrary().map((module): ReferenceEntry => {
    const inputs = module.inputs.map((io) => ({ ...io, sentence: 'Input' }));
    const outputs = module.outputs.map((io) => ({ ...io, sentence: 'Output' }));
    return {
      name: module.name,
      sentence: module.description,
      facts: [
        ['Runs', modeWords(parseMode(module.processingMode))],
        ['Tags', module.tags.join(', ')],
      ],
      fields: [...inputs, ...outputs].map(
        ({ internalName, messageFormat, isRecordList, sentence }) => ({
          name: internalName,
          type: `${isRecordList ? 'list of ' : ''}${formatOf(messageFormat)}`,
          sentence,
        }),
      ),
    };
  });
  return {
    id: 'modules',
    title: 'Modules',
    intro:
      'The modules that come with the master. A session wires their inputs and outputs to topics.',
    sections: [{ title: 'Library', entries }],
  };
}

function wireProtocol(): ReferencePage {
  const { paths, sockets, topicRights, closeCodes } = reference;
  return {
    id: 'wire-protocol',
    title: 'Wire protocol',
    intro:
      'Services travel over HTTP as JSON or protobuf, topic data over a WebSocket as protobuf. All of it is on one port.',
    sections: [
      {
        title: 'Paths',
        entries: [
          ...paths.map(({ method, path, content }) => ({
            name: `${method} ${path}`,
            sentence: capitalised(content),
            facts: [],
          })),
          ...sockets.map(({ path, content }) => ({
            name: `WebSocket ${path}`,
            sentence: capitalised(content),
            facts: [],
          })),
        ],
      },
      {
        title: 'Messages',
        entries: [
          'ubii.topicData.TopicData',
          'ubii.topicData.TopicDataRecord',
          'ubii.topicData.Timestamp',
          'ubii.services.ServiceRequest',
          'ubii.services.ServiceReply',
        ].map(messageEntry),
      },
      {
        title: 'Topics and roles',
        entries: topicRights.map(({ topics, publish, receive }) => ({
          name: topics.replaceAll('`', ''),
          sentence: '',
          facts: [
            ['Publish', roleWords(publish)],
            ['Receive', roleWords(receive)],
          ],
        })),
      },
      {
        title: 'Close codes',
        entries: closeCodes.map(([name = '', meaning = '', client = '']) => ({
          name,
          sentence: capitalised(withoutRules(meaning)),
          facts: [['The client', client]],
        })),
      },
    ],
  };
}

function glossary(): ReferencePage {
  const entries = reference.glossary.map(([name = '', meaning = '', not = '']) => ({
    name,
    sentence: withoutRules(meaning),
    facts: not === '' ? [] : [['Not', not] as const],
  }));
  return {
    id: 'glossary',
    title: 'Glossary',
    intro: 'One word for one thing, the same in the schema, the code and the screens.',
    sections: [{ title: 'Words', entries }],
  };
}

function guides(): ReferencePage {
  const entries = reference.guides.map(([link = '', sentence = '']) => {
    const [, title = '', file = ''] = /\[(.+)\]\((.+)\)/.exec(link) ?? [];
    return { name: title, sentence, facts: [['File', code(`docs/guides/${file}`)]] as const };
  });
  return {
    id: 'guides',
    title: 'Guides',
    intro:
      'Guides extend the product itself. They are files of the repository, each with all steps and the complete code.',
    sections: [{ title: 'Tasks', entries }],
  };
}

/** All reference pages, generated from the sources. */
export const REFERENCE_PAGES: readonly ReferencePage[] = [
  formats(),
  services(),
  modules(),
  wireProtocol(),
  glossary(),
  guides(),
];

/** Id of an entry within its page. */
export const entryId = (name: string): string => name.replace(/[^\w.-]+/g, '-');
