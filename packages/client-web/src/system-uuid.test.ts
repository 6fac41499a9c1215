import { expect, it } from 'vitest';
import { systemUuid } from './system-uuid.ts';

it('systemUuid() gives version 4 UUIDs, each another', () => {
  const ids = Array.from({ length: 1_000 }, systemUuid);
  for (const id of ids) {
    expect(id).toMatch(/^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/);
  }
  expect(new Set(ids).size).toBe(ids.length);
});
