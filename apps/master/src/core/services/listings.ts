import { JOINED, READERS } from '../access/roles.ts';
import { definer, type Service } from './define-service.ts';

const define = definer<'topics'>();

/** The services that list services. @param all returns every service that is answered */
export function listingServices(all: () => readonly Service[]): readonly Service[] {
  return [
    // [SV-9]
    define('serviceList', {
      roles: JOINED,
      handle: () => ({
        elements: all().map(({ info }) => ({
          topic: info.topic,
          requestMessageFormat: info.requestFormat,
          responseMessageFormat: info.replyFormat,
          tags: [],
          description: info.description,
        })),
      }),
    }),
    // [SV-11]
    define('topicList', {
      roles: READERS,
      handle({ topics }) {
        const elements = all().map(({ info }) => info.topic);
        for (const { topic, record, isExtension } of topics.values()) {
          if (record !== undefined && !isExtension) elements.push(topic);
        }
        return { elements };
      },
      gather: ({ elements }, others) => ({
        elements: [...new Set([...(elements ?? []), ...others.flatMap((other) => other.elements)])],
      }),
    }),
  ];
}
