import { expect, it } from 'vitest';
import * as page from './index.ts';
import * as node from './node.ts';
import * as testing from './testing/index.ts';

it('the names of the entry points are these', () => {
  expect({
    page: Object.keys(page).sort(),
    node: Object.keys(node).sort(),
    testing: Object.keys(testing).sort(),
  }).toMatchInlineSnapshot(`
    {
      "node": [
        "ConnectionError",
        "DEFAULT_RECONNECT_POLICY",
        "DecodeError",
        "PROGRAM_EXIT_CODES",
        "PUBLISH_LIMITS",
        "ServiceError",
        "clientRole",
        "connectOnce",
        "createClient",
        "createIdentityFile",
        "createMemoryIdentity",
        "defaultIdentityFile",
        "explainConnectionError",
        "joinProblem",
        "startProgram",
        "systemClock",
      ],
      "page": [
        "ConnectionError",
        "DEFAULT_RECONNECT_POLICY",
        "DecodeError",
        "PUBLISH_LIMITS",
        "ServiceError",
        "clientRole",
        "connectOnce",
        "createClient",
        "createMemoryIdentity",
        "createTabIdentity",
        "explainConnectionError",
        "joinProblem",
        "systemClock",
      ],
      "testing": [
        "FakeMaster",
        "FakeSessions",
        "createMemoryServices",
        "createMemoryTopicData",
        "createTestClient",
        "describeIdentityStorage",
        "describeServiceTransport",
        "describeTopicDataTransport",
      ],
    }
  `);
});
