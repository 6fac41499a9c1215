import { describe, expect, it } from 'vitest';
import { POINTER_DEVICE } from '../../devices/pointer-topic.ts';
import { type PointerClient, Pointers } from './pointers.ts';

const topicOf = (clientId: string) => `/${clientId}/${POINTER_DEVICE}/mouse_client_position`;
const client = (id: string, change: Partial<PointerClient> = {}): PointerClient => ({
  id,
  name: id,
  active: true,
  deviceNames: [POINTER_DEVICE],
  ...change,
});

describe('Pointers', () => {
  it('lists the clients that have the device, by name', () => {
    const pointers = new Pointers();
    pointers.setClients([client('b'), client('a'), client('c', { deviceNames: ['camera'] })]);
    expect(pointers.list().map((pointer) => pointer.clientId)).toEqual(['a', 'b']);
  });

  it('gives a client without a record no position', () => {
    const pointers = new Pointers();
    pointers.setClients([client('a')]);
    expect(pointers.list()[0]?.position).toBeUndefined();
  });

  it('keeps the newest position, inside the pad', () => {
    const pointers = new Pointers();
    pointers.setClients([client('a')]);
    expect(pointers.move(topicOf('a'), { x: 0.2, y: 0.3 })).toBe('a');
    pointers.move(topicOf('a'), { x: -3, y: 7 });
    expect(pointers.list()[0]?.position).toEqual({ x: 0, y: 1 });
  });

  it('keeps a position that arrives before its client is known', () => {
    const pointers = new Pointers();
    pointers.move(topicOf('a'), { x: 0.5, y: 0.5 });
    expect(pointers.list()).toEqual([]);
    pointers.setClients([client('b')]);
    pointers.setClients([client('b'), client('a')]);
    expect(pointers.list()[0]?.position).toEqual({ x: 0.5, y: 0.5 });
  });

  it('keeps a silent client where it was, marked', () => {
    const pointers = new Pointers();
    pointers.setClients([client('a')]);
    pointers.move(topicOf('a'), { x: 0.5, y: 0.5 });
    pointers.setClients([client('a', { active: false })]);
    expect(pointers.list()).toEqual([
      { clientId: 'a', name: 'a', active: false, position: { x: 0.5, y: 0.5 } },
    ]);
  });

  it('forgets a client that left the example', () => {
    const pointers = new Pointers();
    pointers.setClients([client('a')]);
    pointers.move(topicOf('a'), { x: 0.5, y: 0.5 });
    pointers.setClients([client('a', { deviceNames: [] })]);
    pointers.setClients([client('a')]);
    expect(pointers.position('a')).toBeUndefined();
  });

  it('ignores other topics', () => {
    expect(new Pointers().move('/a/camera/image', { x: 0, y: 0 })).toBeUndefined();
  });
});
