import { describe, expect, it, vi } from 'vitest';
import { Listeners } from './listeners.ts';

describe('Listeners', () => {
  it('calls each callback in the order they were added', () => {
    const listeners = new Listeners<number>();
    const calls: string[] = [];
    listeners.add((n) => calls.push(`a${n}`));
    listeners.add((n) => calls.push(`b${n}`));
    listeners.emit(1);
    expect(calls).toEqual(['a1', 'b1']);
  });

  it('takes back one of two equal callbacks', () => {
    const listeners = new Listeners<number>();
    const callback = vi.fn();
    const remove = listeners.add(callback);
    listeners.add(callback);
    remove();
    remove();
    listeners.emit(1);
    expect(callback).toHaveBeenCalledOnce();
  });

  it('lets a callback remove itself and others while being called', () => {
    const listeners = new Listeners<number>();
    const second = vi.fn();
    const removeFirst = listeners.add(() => {
      removeFirst();
      removeSecond();
    });
    const removeSecond = listeners.add(second);
    listeners.emit(1);
    listeners.emit(2);
    expect(second).toHaveBeenCalledOnce();
  });

  it('calls the others when one throws, and lets the exception surface', async () => {
    const surfaced = new Promise((resolve) => process.once('unhandledRejection', resolve));
    const listeners = new Listeners<number>();
    const second = vi.fn();
    listeners.add(() => {
      throw new Error('a fault of the program');
    });
    listeners.add(second);
    listeners.emit(1);
    expect(second).toHaveBeenCalledOnce();
    expect(await surfaced).toMatchObject({ message: 'a fault of the program' });
  });
});
