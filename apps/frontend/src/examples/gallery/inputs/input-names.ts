/** Inputs that a page can provide to a session: pointer, clicks, keys. */
export type InputName = 'pointer' | 'pressed' | 'escape' | 'key';
