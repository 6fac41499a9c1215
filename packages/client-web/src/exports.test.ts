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
        "PUBLISH_LIMITS",
        "ServiceError",
        "clientRole",
        "createClient",
        "createMemoryIdentity",
        "joinProblem",
        "systemClock",
      ],
      "page": [
        "ConnectionError",
        "DEFAULT_RECONNECT_POLICY",
        "DecodeError",
        "PUBLISH_LIMITS",
        "ServiceError",
        "clientRole",
        "createClient",
        "createMemoryIdentity",
        "createTabIdentity",
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
