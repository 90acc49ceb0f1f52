// Says where a `src` leads: to this site, which may be loaded at once; to another host, which needs
// a click; or to an address that a link must not use (javascript:, data:, blob:, file:).

export type SourceKind = 'own' | 'refused' | { readonly host: string };

/** @param base the address that relative sources refer to. */
export function sourceKind(source: string, base: string): SourceKind {
  if (!URL.canParse(source, base)) return 'refused';
  const { protocol, origin } = new URL(source, base);
  // Checked first: the origin of `blob:https://this.site/…` is this site's.
  if (protocol !== 'http:' && protocol !== 'https:') return 'refused';
  return origin === new URL(base).origin ? 'own' : { host: origin };
}
