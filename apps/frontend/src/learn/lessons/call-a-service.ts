import { serviceRefused, serviceReplied } from '../model/checks.ts';
import type { Lesson } from '../model/lesson.ts';

interface Replies {
  readonly server?: { readonly name?: string };
  readonly name?: string;
  readonly elements?: readonly { readonly id?: string; readonly name?: string }[];
}

export const callAService: Lesson = {
  id: 'call-a-service',
  title: 'Call a service',
  heading: 'Call a service',
  intro:
    'Topics carry streams. A service is one request and one reply: it registers devices, starts sessions, or returns the state of the master.',
  minutes: 3,
  workspace: {
    kind: 'service',
    services: ['serverConfiguration', 'topicList', 'clientGetList', 'sessionRuntimeStop'],
  },
  steps: [
    {
      title: 'Ask the master for its name',
      text: 'Select `server_configuration`. It takes no request. Press Call. The reply appears below, with the time from the request to the reply.',
      checks: [
        serviceReplied('serverConfiguration', ({ reply }) => (reply as Replies).name || undefined, {
          id: 'reply',
          text: 'The master replies with its name',
          todo: 'press Call',
        }),
      ],
      answer: { kind: 'call', service: 'serverConfiguration' },
    },
    {
      title: 'List the topics',
      text: 'Select `topic_list` and call it. The reply has another format, a `stringList`: each service has one format for its request and one for its reply.',
      checks: [
        serviceReplied(
          'topicList',
          ({ reply }) => `${(reply as Replies).elements?.length ?? 0} topics`,
          { id: 'reply', text: 'The master lists its topics', todo: 'call topic_list' },
        ),
      ],
      answer: { kind: 'call', service: 'topicList' },
    },
    {
      title: 'Send a request',
      text: 'Select `client/get_list` and turn on With a request. Add one element and write your client id into its field `id`, or use JSON. The request is a profile: the reply holds only clients that match it.',
      checks: [
        serviceReplied(
          'clientGetList',
          ({ reply }, { ownId }) => {
            const clients = (reply as Replies).elements ?? [];
            const isOwn = clients.length === 1 && clients[0]?.id === ownId;
            return isOwn ? (clients[0]?.name ?? '1 client') : undefined;
          },
          { id: 'reply', text: 'The reply holds this client alone', todo: 'call client/get_list' },
        ),
      ],
      answer: { kind: 'call', service: 'clientGetList' },
    },
    {
      title: 'Read an error',
      text: 'Select `session/runtime/stop` and write an `id` that does not exist, such as `nothing`. The master answers every call: an error has a code from a fixed list and one sentence.',
      checks: [
        serviceRefused('sessionRuntimeStop', 'not_found', {
          id: 'error',
          text: 'The master replies with `not_found`',
          todo: 'call session/runtime/stop',
        }),
      ],
      answer: { kind: 'call', service: 'sessionRuntimeStop', request: { id: 'nothing' } },
    },
  ],
};
