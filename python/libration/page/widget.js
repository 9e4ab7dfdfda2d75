// node_modules/lit-html/lit-html.js
var e = globalThis, t = (e) => e, n = e.trustedTypes, r = n ? n.createPolicy("lit-html", { createHTML: (e) => e }) : void 0, i = "$lit$", a = `lit$${Math.random().toFixed(9).slice(2)}$`, o = "?" + a, s = `<${o}>`, c = document, l = () => c.createComment(""), u = (e) => e === null || typeof e != "object" && typeof e != "function", d = Array.isArray, f = (e) => d(e) || typeof e?.[Symbol.iterator] == "function", p = "[ 	\n\f\r]", m = /<(?:(!--|\/[^a-zA-Z])|(\/?[a-zA-Z][^>\s]*)|(\/?$))/g, ee = /-->/g, te = />/g, h = RegExp(`>|${p}(?:([^\\s"'>=/]+)(${p}*=${p}*(?:[^ \t\n\f\r"'\`<>=]|("|')|))|$)`, "g"), ne = /'/g, re = /"/g, ie = /^(?:script|style|textarea|title)$/i, ae = (e) => (t, ...n) => ({
	_$litType$: e,
	strings: t,
	values: n
}), g = ae(1), _ = ae(2), v = Symbol.for("lit-noChange"), y = Symbol.for("lit-nothing"), oe = /* @__PURE__ */ new WeakMap(), b = c.createTreeWalker(c, 129);
function se(e, t) {
	if (!d(e) || !e.hasOwnProperty("raw")) throw Error("invalid template strings array");
	return r === void 0 ? t : r.createHTML(t);
}
var ce = (e, t) => {
	let n = e.length - 1, r = [], o, c = t === 2 ? "<svg>" : t === 3 ? "<math>" : "", l = m;
	for (let t = 0; t < n; t++) {
		let n = e[t], u, d, f = -1, p = 0;
		for (; p < n.length && (l.lastIndex = p, d = l.exec(n), d !== null);) p = l.lastIndex, l === m ? d[1] === "!--" ? l = ee : d[1] === void 0 ? d[2] === void 0 ? d[3] !== void 0 && (l = h) : (ie.test(d[2]) && (o = RegExp("</" + d[2], "g")), l = h) : l = te : l === h ? d[0] === ">" ? (l = o ?? m, f = -1) : d[1] === void 0 ? f = -2 : (f = l.lastIndex - d[2].length, u = d[1], l = d[3] === void 0 ? h : d[3] === "\"" ? re : ne) : l === re || l === ne ? l = h : l === ee || l === te ? l = m : (l = h, o = void 0);
		let ae = l === h && e[t + 1].startsWith("/>") ? " " : "";
		c += l === m ? n + s : f >= 0 ? (r.push(u), n.slice(0, f) + i + n.slice(f) + a + ae) : n + a + (f === -2 ? t : ae);
	}
	return [se(e, c + (e[n] || "<?>") + (t === 2 ? "</svg>" : t === 3 ? "</math>" : "")), r];
}, le = class e {
	constructor({ strings: t, _$litType$: r }, s) {
		let c;
		this.parts = [];
		let u = 0, d = 0, f = t.length - 1, p = this.parts, [m, ee] = ce(t, r);
		if (this.el = e.createElement(m, s), b.currentNode = this.el.content, r === 2 || r === 3) {
			let e = this.el.content.firstChild;
			e.replaceWith(...e.childNodes);
		}
		for (; (c = b.nextNode()) !== null && p.length < f;) {
			if (c.nodeType === 1) {
				if (c.hasAttributes()) for (let e of c.getAttributeNames()) if (e.endsWith(i)) {
					let t = ee[d++], n = c.getAttribute(e).split(a), r = /([.?@])?(.*)/.exec(t);
					p.push({
						type: 1,
						index: u,
						name: r[2],
						strings: n,
						ctor: r[1] === "." ? pe : r[1] === "?" ? me : r[1] === "@" ? he : fe
					}), c.removeAttribute(e);
				} else e.startsWith(a) && (p.push({
					type: 6,
					index: u
				}), c.removeAttribute(e));
				if (ie.test(c.tagName)) {
					let e = c.textContent.split(a), t = e.length - 1;
					if (t > 0) {
						c.textContent = n ? n.emptyScript : "";
						for (let n = 0; n < t; n++) c.append(e[n], l()), b.nextNode(), p.push({
							type: 2,
							index: ++u
						});
						c.append(e[t], l());
					}
				}
			} else if (c.nodeType === 8) {
				if (c.data === o) p.push({
					type: 2,
					index: u
				});
				else {
					let e = -1;
					for (; (e = c.data.indexOf(a, e + 1)) !== -1;) p.push({
						type: 7,
						index: u
					}), e += a.length - 1;
				}
			}
			u++;
		}
	}
	static createElement(e, t) {
		let n = c.createElement("template");
		return n.innerHTML = e, n;
	}
};
function x(e, t, n = e, r) {
	if (t === v) return t;
	let i = r === void 0 ? n._$Cl : n._$Co?.[r], a = u(t) ? void 0 : t._$litDirective$;
	return i?.constructor !== a && (i?._$AO?.(!1), a === void 0 ? i = void 0 : (i = new a(e), i._$AT(e, n, r)), r === void 0 ? n._$Cl = i : (n._$Co ??= [])[r] = i), i !== void 0 && (t = x(e, i._$AS(e, t.values), i, r)), t;
}
var ue = class {
	constructor(e, t) {
		this._$AV = [], this._$AN = void 0, this._$AD = e, this._$AM = t;
	}
	get parentNode() {
		return this._$AM.parentNode;
	}
	get _$AU() {
		return this._$AM._$AU;
	}
	u(e) {
		let { el: { content: t }, parts: n } = this._$AD, r = (e?.creationScope ?? c).importNode(t, !0);
		b.currentNode = r;
		let i = b.nextNode(), a = 0, o = 0, s = n[0];
		for (; s !== void 0;) {
			if (a === s.index) {
				let t;
				s.type === 2 ? t = new de(i, i.nextSibling, this, e) : s.type === 1 ? t = new s.ctor(i, s.name, s.strings, this, e) : s.type === 6 && (t = new ge(i, this, e)), this._$AV.push(t), s = n[++o];
			}
			a !== s?.index && (i = b.nextNode(), a++);
		}
		return b.currentNode = c, r;
	}
	p(e) {
		let t = 0;
		for (let n of this._$AV) n !== void 0 && (n.strings === void 0 ? n._$AI(e[t]) : (n._$AI(e, n, t), t += n.strings.length - 2)), t++;
	}
}, de = class e {
	get _$AU() {
		return this._$AM?._$AU ?? this._$Cv;
	}
	constructor(e, t, n, r) {
		this.type = 2, this._$AH = y, this._$AN = void 0, this._$AA = e, this._$AB = t, this._$AM = n, this.options = r, this._$Cv = r?.isConnected ?? !0;
	}
	get parentNode() {
		let e = this._$AA.parentNode, t = this._$AM;
		return t !== void 0 && e?.nodeType === 11 && (e = t.parentNode), e;
	}
	get startNode() {
		return this._$AA;
	}
	get endNode() {
		return this._$AB;
	}
	_$AI(e, t = this) {
		e = x(this, e, t), u(e) ? e === y || e == null || e === "" ? (this._$AH !== y && this._$AR(), this._$AH = y) : e !== this._$AH && e !== v && this._(e) : e._$litType$ === void 0 ? e.nodeType === void 0 ? f(e) ? this.k(e) : this._(e) : this.T(e) : this.$(e);
	}
	O(e) {
		return this._$AA.parentNode.insertBefore(e, this._$AB);
	}
	T(e) {
		this._$AH !== e && (this._$AR(), this._$AH = this.O(e));
	}
	_(e) {
		this._$AH !== y && u(this._$AH) ? this._$AA.nextSibling.data = e : this.T(c.createTextNode(e)), this._$AH = e;
	}
	$(e) {
		let { values: t, _$litType$: n } = e, r = typeof n == "number" ? this._$AC(e) : (n.el === void 0 && (n.el = le.createElement(se(n.h, n.h[0]), this.options)), n);
		if (this._$AH?._$AD === r) this._$AH.p(t);
		else {
			let e = new ue(r, this), n = e.u(this.options);
			e.p(t), this.T(n), this._$AH = e;
		}
	}
	_$AC(e) {
		let t = oe.get(e.strings);
		return t === void 0 && oe.set(e.strings, t = new le(e)), t;
	}
	k(t) {
		d(this._$AH) || (this._$AH = [], this._$AR());
		let n = this._$AH, r, i = 0;
		for (let a of t) i === n.length ? n.push(r = new e(this.O(l()), this.O(l()), this, this.options)) : r = n[i], r._$AI(a), i++;
		i < n.length && (this._$AR(r && r._$AB.nextSibling, i), n.length = i);
	}
	_$AR(e = this._$AA.nextSibling, n) {
		for (this._$AP?.(!1, !0, n); e !== this._$AB;) {
			let n = t(e).nextSibling;
			t(e).remove(), e = n;
		}
	}
	setConnected(e) {
		this._$AM === void 0 && (this._$Cv = e, this._$AP?.(e));
	}
}, fe = class {
	get tagName() {
		return this.element.tagName;
	}
	get _$AU() {
		return this._$AM._$AU;
	}
	constructor(e, t, n, r, i) {
		this.type = 1, this._$AH = y, this._$AN = void 0, this.element = e, this.name = t, this._$AM = r, this.options = i, n.length > 2 || n[0] !== "" || n[1] !== "" ? (this._$AH = Array(n.length - 1).fill(/* @__PURE__ */ new String()), this.strings = n) : this._$AH = y;
	}
	_$AI(e, t = this, n, r) {
		let i = this.strings, a = !1;
		if (i === void 0) e = x(this, e, t, 0), a = !u(e) || e !== this._$AH && e !== v, a && (this._$AH = e);
		else {
			let r = e, o, s;
			for (e = i[0], o = 0; o < i.length - 1; o++) s = x(this, r[n + o], t, o), s === v && (s = this._$AH[o]), a ||= !u(s) || s !== this._$AH[o], s === y ? e = y : e !== y && (e += (s ?? "") + i[o + 1]), this._$AH[o] = s;
		}
		a && !r && this.j(e);
	}
	j(e) {
		e === y ? this.element.removeAttribute(this.name) : this.element.setAttribute(this.name, e ?? "");
	}
}, pe = class extends fe {
	constructor() {
		super(...arguments), this.type = 3;
	}
	j(e) {
		this.element[this.name] = e === y ? void 0 : e;
	}
}, me = class extends fe {
	constructor() {
		super(...arguments), this.type = 4;
	}
	j(e) {
		this.element.toggleAttribute(this.name, !!e && e !== y);
	}
}, he = class extends fe {
	constructor(e, t, n, r, i) {
		super(e, t, n, r, i), this.type = 5;
	}
	_$AI(e, t = this) {
		if ((e = x(this, e, t, 0) ?? y) === v) return;
		let n = this._$AH, r = e === y && n !== y || e.capture !== n.capture || e.once !== n.once || e.passive !== n.passive, i = e !== y && (n === y || r);
		r && this.element.removeEventListener(this.name, this, n), i && this.element.addEventListener(this.name, this, e), this._$AH = e;
	}
	handleEvent(e) {
		typeof this._$AH == "function" ? this._$AH.call(this.options?.host ?? this.element, e) : this._$AH.handleEvent(e);
	}
}, ge = class {
	constructor(e, t, n) {
		this.element = e, this.type = 6, this._$AN = void 0, this._$AM = t, this.options = n;
	}
	get _$AU() {
		return this._$AM._$AU;
	}
	_$AI(e) {
		x(this, e);
	}
}, _e = {
	M: i,
	P: a,
	A: o,
	C: 1,
	L: ce,
	R: ue,
	D: f,
	V: x,
	I: de,
	H: fe,
	N: me,
	U: he,
	B: pe,
	F: ge
}, ve = e.litHtmlPolyfillSupport;
ve?.(le, de), (e.litHtmlVersions ??= []).push("3.3.3");
var ye = (e, t, n) => {
	let r = n?.renderBefore ?? t, i = r._$litPart$;
	if (i === void 0) {
		let e = n?.renderBefore ?? null;
		r._$litPart$ = i = new de(t.insertBefore(l(), e), e, void 0, n ?? {});
	}
	return i._$AI(e), i;
}, { I: be } = _e, xe = (e) => e.strings === void 0, Se = {
	ATTRIBUTE: 1,
	CHILD: 2,
	PROPERTY: 3,
	BOOLEAN_ATTRIBUTE: 4,
	EVENT: 5,
	ELEMENT: 6
}, Ce = (e) => (...t) => ({
	_$litDirective$: e,
	values: t
}), we = class {
	constructor(e) {}
	get _$AU() {
		return this._$AM._$AU;
	}
	_$AT(e, t, n) {
		this._$Ct = e, this._$AM = t, this._$Ci = n;
	}
	_$AS(e, t) {
		return this.update(e, t);
	}
	update(e, t) {
		return this.render(...t);
	}
}, Te = (e, t) => {
	let n = e._$AN;
	if (n === void 0) return !1;
	for (let e of n) e._$AO?.(t, !1), Te(e, t);
	return !0;
}, Ee = (e) => {
	let t, n;
	do {
		if ((t = e._$AM) === void 0) break;
		n = t._$AN, n.delete(e), e = t;
	} while (n?.size === 0);
}, De = (e) => {
	for (let t; t = e._$AM; e = t) {
		let n = t._$AN;
		if (n === void 0) t._$AN = n = /* @__PURE__ */ new Set();
		else if (n.has(e)) break;
		n.add(e), Ae(t);
	}
};
function Oe(e) {
	this._$AN === void 0 ? this._$AM = e : (Ee(this), this._$AM = e, De(this));
}
function ke(e, t = !1, n = 0) {
	let r = this._$AH, i = this._$AN;
	if (i !== void 0 && i.size !== 0) {
		if (t) {
			if (Array.isArray(r)) for (let e = n; e < r.length; e++) Te(r[e], !1), Ee(r[e]);
			else r != null && (Te(r, !1), Ee(r));
		} else Te(this, e);
	}
}
var Ae = (e) => {
	e.type == Se.CHILD && (e._$AP ??= ke, e._$AQ ??= Oe);
}, je = class extends we {
	constructor() {
		super(...arguments), this._$AN = void 0;
	}
	_$AT(e, t, n) {
		super._$AT(e, t, n), De(this), this.isConnected = e._$AU;
	}
	_$AO(e, t = !0) {
		e !== this.isConnected && (this.isConnected = e, e ? this.reconnected?.() : this.disconnected?.()), t && (Te(this, e), Ee(this));
	}
	setValue(e) {
		if (xe(this._$Ct)) this._$Ct._$AI(e, this);
		else {
			let t = [...this._$Ct._$AH];
			t[this._$Ci] = e, this._$Ct._$AI(t, this, 0);
		}
	}
	disconnected() {}
	reconnected() {}
}, Me = /* @__PURE__ */ new Map(), Ne = () => {};
function Pe(e) {
	Ne = e;
}
function Fe(e) {
	return Me.get(e);
}
var Ie = Ce(class extends je {
	#e = null;
	#t = null;
	#n = "";
	constructor(e) {
		if (super(e), e.type !== Se.ELEMENT) throw Error("measured() stands in an element");
	}
	render(e) {}
	update(e, [t]) {
		this.#n = t, this.#t !== e.element && (this.#e?.disconnect(), this.#t = e.element, this.#r());
	}
	#r() {
		this.#t && (this.#e = new ResizeObserver(([e]) => {
			if (!e) return;
			let { width: t, height: n } = e.contentRect, r = Me.get(this.#n);
			(r?.width !== t || r.height !== n) && (Me.set(this.#n, {
				width: t,
				height: n
			}), Ne());
		}), this.#e.observe(this.#t));
	}
	disconnected() {
		this.#e?.disconnect(), this.#e = null;
	}
	reconnected() {
		this.#r();
	}
});
function Le() {
	return Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
}
// src/draw/icons.ts
var Re = {
	play: _`<path d="M5 3l12 7-12 7z"/>`,
	pause: _`<path d="M5 3h3.5v14H5zM11.5 3H15v14h-3.5z"/>`,
	back: _`<path d="M12 4l-6 6 6 6M15.5 4v12"/>`,
	step: _`<path d="M8 4l6 6-6 6M4.5 4v12"/>`,
	before: _`<path d="M12.5 4l-6 6 6 6"/>`,
	next: _`<path d="M7.5 4l6 6-6 6"/>`,
	table: _`<path d="M3 4h14v12H3zM3 8h14M3 12h14M8 4v12"/>`,
	sound: _`<path d="M3 8v4h3l4 3.5v-11L6 8zM13 7.5a3.5 3.5 0 010 5M15.5 5a7 7 0 010 10"/>`,
	plus: _`<path d="M10 4v12M4 10h12"/>`,
	open: _`<path d="M8 4H4v12h12v-4M11 4h5v5M16 4l-7 7"/>`,
	share: _`<path d="M10 12V3M6.5 6L10 2.5 13.500 6M5 9H4v8h12V9h-1"/>`,
	save: _`<path d="M10 3v9M6.5 8.5l3.5 3.5 3.5-3.5M4 13v4h12v-4"/>`,
	sun: _`<circle cx="10" cy="10" r="3.5"/><path d="M10 2v2M10 16v2M2 10h2M16 10h2M4.3 4.3l1.4 1.4M14.3 14.3l1.4 1.4M4.3 15.7l1.4-1.4M14.3 5.7l1.4-1.4"/>`,
	moon: _`<path d="M16 12.5A6.5 6.5 0 017.5 4 6.5 6.5 0 1016 12.5z"/>`,
	auto: _`<circle cx="10" cy="10" r="6.5"/><path d="M10 3.5v13a6.5 6.5 0 000-13z" fill="currentColor"/>`,
	keys: _`<path d="M2.5 5.5h15v9h-15zM5.5 8.5h.01M8.5 8.5h.01M11.5 8.5h.01M14.5 8.5h.01M6 11.5h8"/>`,
	down: _`<path d="M5 8l5 5 5-5"/>`,
	close: _`<path d="M5 5l10 10M15 5L5 15"/>`,
	lock: _`<path d="M5 9h10v8H5zM7 9V6.5a3 3 0 016 0V9"/>`,
	dots: _`<circle cx="10" cy="4.5" r=".8"/><circle cx="10" cy="10" r=".8"/><circle cx="10" cy="15.5" r=".8"/>`,
	warn: _`<path d="M10 3l8 14H2zM10 8.5v4M10 14.8v.01"/>`,
	check: _`<path d="M4 10.500l4 4 8-9"/>`
};
function S(e) {
	return g`<svg class="icon-drawing" viewBox="0 0 20 20" aria-hidden="true">${Re[e]}</svg>`;
}
g`<svg class="mark-drawing" viewBox="0 0 24 24" aria-hidden="true"><path d="M3.5 12a8.5 8.5 0 0017 0" fill="none" stroke="var(--edge)" stroke-width="1.5"/><path d="M12 4l6.2 12" stroke="var(--ink)" stroke-width="2"/><circle cx="18" cy="16.5" r="3.6" class="bob" style="stroke-width:1.5"/><circle cx="12" cy="4" r="1.6" fill="var(--ink)"/></svg>`;
// src/language/rich.ts
var ze = /\*([^*]+)\*|_([^_{}]+)_(?:\{([^}]+)\})?|\^\{([^}]+)\}/g;
function Be(e) {
	if (!/[*_^]/.test(e)) return e === "" ? [] : [{
		kind: "text",
		text: e
	}];
	let t = [], n = 0, r = (e, n) => n !== "" && t.push({
		kind: e,
		text: n
	});
	for (let t of e.matchAll(ze)) {
		r("text", e.slice(n, t.index));
		let [i, a, o, s, c] = t;
		a === void 0 ? o === void 0 ? r("power", c ?? "") : (o.endsWith("''") ? r("twice", o.slice(0, -2)) : o.endsWith("'") ? r("dotted", o.slice(0, -1)) : r("symbol", o), r("index", s ?? "")) : r("bold", a), n = t.index + i.length;
	}
	return r("text", e.slice(n)), t;
}
function C(e, t = {}) {
	return g`${Be(e).map((e) => {
		switch (e.kind) {
			case "bold": return g`<b>${C(e.text, t)}</b>`;
			case "symbol": return g`<i>${e.text}</i>`;
			case "dotted": return g`<i class="dotted">${e.text}</i>`;
			case "twice": return g`<i class="dotted twice">${e.text}</i>`;
			case "index": return g`<sub>${C(e.text)}</sub>`;
			case "power": return g`<sup>${e.text}</sup>`;
			default: return Ue(e.text, t);
		}
	})}`;
}
function Ve(e) {
	return _`${Be(e).map((e) => {
		switch (e.kind) {
			case "bold": return _`<tspan font-weight="650">${e.text}</tspan>`;
			case "symbol": return _`<tspan class="symbol">${e.text}</tspan>`;
			case "dotted": return _`<tspan class="symbol">${e.text}</tspan><tspan class="symbol" dx="-0.3em" dy="-0.85em">.</tspan><tspan class="symbol" dx="0.06em" dy="0.85em">\u200b</tspan>`;
			case "twice": return _`<tspan class="symbol">${e.text}</tspan><tspan class="symbol" dx="-0.42em" dy="-0.85em">..</tspan><tspan class="symbol" dx="-0.06em" dy="0.85em">\u200b</tspan>`;
			case "index": return _`<tspan dy="3" font-size="72%">${e.text}</tspan><tspan dy="-3">\u200b</tspan>`;
			case "power": return _`<tspan dy="-4" font-size="72%">${e.text}</tspan><tspan dy="4">\u200b</tspan>`;
			default: return e.text || y;
		}
	})}`;
}
function w(e) {
	return Be(e).map(({ kind: e, text: t }) => e === "dotted" ? `${t}\u0307` : e === "twice" ? `${t}\u0308` : e === "power" ? He(t) : e === "bold" ? w(t) : t).join("");
}
function He(e) {
	return e.replace(/[−0-9]/g, (e) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["−0123456789".indexOf(e)] ?? e);
}
function Ue(e, t) {
	return e.replace(/\{([a-zA-Z]\w*)\}/g, (e, n) => String(t[n] ?? e));
}
// src/controls/slide.ts
function We(e, t) {
	let { value: n, least: r, most: i, step: a } = t, o = (e) => {
		let t = Number((n + e).toPrecision(12));
		return Math.min(i, Math.max(r, t));
	}, s = e.shiftKey ? a / 10 : a;
	switch (e.key) {
		case "ArrowRight":
		case "ArrowUp": return o(s);
		case "ArrowLeft":
		case "ArrowDown": return o(-s);
		case "PageUp": return o(10 * a);
		case "PageDown": return o(-10 * a);
		case "Home": return r;
		case "End": return i;
		default: return null;
	}
}
function Ge(e) {
	return (t) => {
		if (t.button !== 0) return;
		let n = t.currentTarget;
		t.preventDefault(), n.setPointerCapture(t.pointerId), n.tabIndex >= 0 && n.focus({ preventScroll: !0 }), e.begin?.(), e.at(t.clientX, t.clientY, n);
		let r = new AbortController(), { signal: i } = r, a = (t) => {
			r.abort(), e.end?.(t);
		};
		n.addEventListener("pointermove", (t) => e.at(t.clientX, t.clientY, n), { signal: i }), n.addEventListener("pointerup", () => a(!1), { signal: i }), n.addEventListener("pointercancel", () => a(!1), { signal: i }), window.addEventListener("keydown", (e) => e.key === "Escape" && a(!0), { signal: i });
	};
}
function Ke(e, t) {
	let n = t.getBoundingClientRect();
	return Math.min(1, Math.max(0, (e - n.left) / n.width));
}
// src/controls/value.ts
var qe = (e, { least: t, most: n }) => 100 * (Math.min(Math.max(e, t), n) - t) / (n - t);
function Je(e, t) {
	let { key: n, unit: r, text: i, draft: a, fault: o, locked: s } = e, c = `field-${n}`;
	return g`<label class="field ${o ? "bad" : ""} ${s ? "locked" : ""}">
    <span class="unseen">${t}</span>
    <input id=${c} inputmode="decimal" autocomplete="off" spellcheck="false" ?disabled=${s} .value=${a ?? i}
      aria-invalid=${o ? "true" : "false"} aria-describedby=${o ? `${c}-fault` : y} style="width:${Math.max(2.75, .55 * (a ?? i).length)}rem"
      @input=${(t) => e.onText(t.target.value)}
      @blur=${e.onDone}
      @keydown=${(t) => {
		if (t.key === "Enter" && e.onDone(), t.key === "ArrowUp" || t.key === "ArrowDown") {
			let n = We(t, {
				...e,
				value: e.current?.() ?? e.value
			});
			t.preventDefault(), n !== null && e.onSlide(n);
		}
	}}>
    ${r ? g`<span class="unit">${r}</span>` : y}${s ? S("lock") : y}</label>`;
}
function Ye(e) {
	let { value: t, least: n, most: r, origin: i, locked: a } = e, o = qe(t, e), s = qe(i, e), c = e.label, l = (t, i) => {
		let a = n + (r - n) * Ke(t, i);
		e.onSlide(Number((e.grain * Math.round(a / e.grain)).toPrecision(12)));
	};
	return g`<div class="track" @pointerdown=${a ? y : Ge({
		at: (e, t, n) => l(e, n),
		begin: () => e.onHold(!0),
		end: () => e.onHold(!1)
	})}>
    ${e.ticks.map((t) => g`<i class="notch" style="left:${qe(t, e)}%"></i>`)}
    <i class="fill" style="left:${Math.min(o, s)}%;width:${Math.abs(o - s)}%"></i>
    <b class="handle" role="slider" tabindex=${a ? -1 : 0} aria-label=${c} aria-valuemin=${n} aria-valuemax=${r}
      aria-valuenow=${t} aria-valuetext=${e.spoken} aria-disabled=${a ? "true" : y} style="left:${o}%"
      @keydown=${(t) => {
		let n = a ? null : We(t, {
			...e,
			value: e.current?.() ?? e.value
		});
		n !== null && (t.preventDefault(), t.stopPropagation(), e.onSlide(n));
	}}></b>
  </div>`;
}
var Xe = ({ fault: e, key: t }) => e ? g`<p class="fault" id="field-${t}-fault" role="alert">${S("warn")}<span>${e}</span></p>` : y;
function Ze(e) {
	return g`<div class="value" data-value=${e.key} title=${e.title ?? y}>
    <span>${e.label} ${C(e.symbol)}</span>${Je(e, e.label)}${Ye(e)}
    ${Xe(e)}
  </div>`;
}
// src/number.ts
function T(e) {
	let t = e.trim().replace(/[\u2212\u2013]/g, "-").replace(/[\s\u00a0\u202f]/g, "").replace(",", ".");
	return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(t) ? Number(t) : NaN;
}
var Qe = {
	deg: {
		deg: Math.PI / 180,
		"°": Math.PI / 180,
		rad: 1
	},
	"rad/s": {
		"rad/s": 1,
		"deg/s": Math.PI / 180,
		"°/s": Math.PI / 180
	},
	m: {
		m: 1,
		cm: .01,
		mm: .001
	},
	"m/s2": {
		"m/s2": 1,
		"m/s²": 1
	},
	s: {
		s: 1,
		ms: .001
	},
	kg: {
		kg: 1,
		g: .001
	},
	"1/s": { "1/s": 1 },
	"1/rad": { "1/rad": 1 },
	"rad/s2": {
		"rad/s2": 1,
		"rad/s²": 1
	},
	"": {}
};
function E(e, t) {
	let n = T(t.startsWith("1/") && e.trim().endsWith(` ${t}`) ? e.trim().slice(0, -t.length) : e), r = /^(.*?)\s*([a-z°][a-z°/²]*[0-9]?)?$/i.exec(e.trim());
	if (!r) return NaN;
	let i = Qe[t], a = Number.isNaN(n) ? r[2] ?? t : t, o = a === "" ? 1 : i[a];
	if (o === void 0) return NaN;
	let s = Number.isNaN(n) ? T(r[1] ?? "") : n;
	return o === Qe.deg.deg ? D(s) : o === .01 ? s / 100 : o === .001 ? s / 1e3 : s * o;
}
var $e = .017453292519943295, et = 29486522708701687e-35, tt = 134217729;
function D(e) {
	let t = e * $e;
	if (!Number.isFinite(t) || Math.abs(e) > 1e100) return t;
	let n = tt * e - (tt * e - e), r = tt * $e - (tt * $e - $e), [i, a] = [e - n, 13519960498364902e-26];
	return t + (n * r - t + n * a + i * r + i * a + e * et);
}
function nt(e) {
	return String(Number(e.toPrecision(12)));
}
var rt = 180 / Math.PI;
function O(e) {
	return Number((e * 180 / Math.PI).toPrecision(12));
}
function it(e) {
	let t = `${O(e)}deg`;
	return E(t, "deg") === e ? t : `${e}rad`;
}
// src/curves.ts
var at = (e, t, n) => ({
	of: "order",
	least: e,
	most: t,
	usual: n
}), ot = {
	of: "step",
	least: 1e-4,
	most: 1,
	usual: .025
}, k = (e, t) => t ? {
	family: e,
	argument: t,
	numerical: !1
} : {
	family: e,
	numerical: !1
}, st = (e, t) => t ? {
	family: e,
	argument: t,
	numerical: !0
} : {
	family: e,
	numerical: !0
}, ct = {
	linear: k("linear"),
	harmonic: k("harmonic"),
	fourier: k("fourier", at(1, 50, 4)),
	"fourier-theta": k("fourier", at(1, 50, 2)),
	trigonometric: k("trigonometric"),
	"small-m": k("polynomial"),
	"small-m-bounded": k("polynomial"),
	cubic: k("polynomial"),
	"cubic-quintic": k("polynomial"),
	taylor: k("polynomial", at(1, 100, 8)),
	rk45: st("integrator"),
	rk4: st("integrator", ot),
	verlet: st("integrator", ot),
	"euler-cromer": st("euler", ot),
	euler: st("euler", ot)
};
Object.keys(ct);
function A(e) {
	return ct[e];
}
function lt(e) {
	return Object.hasOwn(ct, e);
}
function ut(e) {
	let { argument: t } = A(e);
	return t ? {
		name: e,
		argument: t.usual,
		on: !0
	} : {
		name: e,
		on: !0
	};
}
function j(e) {
	return e.argument === void 0 ? e.name : `${e.name}:${e.argument}`;
}
// src/state.ts
var dt = [
	"lab",
	"phase",
	"period",
	"functions",
	"derivation",
	"springs",
	"friction",
	"data",
	"handouts"
], ft = [
	"novice",
	"lima",
	"salas"
], pt = ["file", "period"], mt = [
	"en",
	"pt-BR",
	"es"
], ht = [
	"auto",
	"light",
	"dark"
], gt = [
	"worksheet",
	"code",
	"embed"
], _t = ["A4", "Letter"], vt = [
	"scipy",
	"mpmath",
	"libration",
	"octave",
	"r",
	"mathematica"
], yt = [
	"pendulum",
	"values",
	"facts",
	"motion",
	"error",
	"energy",
	"curves",
	"portrait",
	"play"
], bt = [...dt, ...yt], xt = {
	th0: "theta0",
	w0: "velocity0",
	L: "length",
	g: "gravity",
	curves: "curves"
}, St = Object.keys(xt), Ct = [
	"duffing",
	"helmholtz-duffing",
	"cubic-quintic"
], wt = {
	view: "lab",
	theta0: D(150),
	velocity0: 0,
	length: 1,
	gravity: 9.81,
	curves: [
		{
			name: "linear",
			on: !0
		},
		{
			name: "harmonic",
			on: !0
		},
		{
			name: "fourier",
			argument: 4,
			on: !0
		},
		{
			name: "rk45",
			on: !0
		}
	],
	t: 0,
	speed: 1,
	span: 8,
	quantity: "angle",
	errorAxis: "auto",
	errorUnit: "percent",
	energy: "auto",
	orbits: [{
		theta0: D(60),
		velocity0: 0
	}, {
		theta0: 0,
		velocity0: 7.5
	}],
	orbit: 0,
	periods: null,
	periodAxis: "log",
	periodOrder: "registry",
	entry: "novice",
	step: 1,
	from: "file",
	spring: "duffing",
	p: 1,
	r: 0,
	q: -.5,
	c: 0,
	s: 0,
	u0: 1.2,
	springVelocity0: 0,
	linear: .05,
	quadratic: 0,
	dry: 0,
	torque: 0,
	drive: 0,
	driveFrequency: 2,
	until: 30,
	language: "auto",
	theme: "auto",
	handout: "worksheet",
	seed: 1,
	key: !1,
	paper: "A4",
	code: "scipy",
	embed: !1,
	lock: [],
	show: [],
	hide: !1
}, Tt = [
	.25,
	.5,
	1,
	2
], Et = "ABCDEF", M = {
	theta0: {
		unit: "deg",
		least: -Math.PI,
		most: Math.PI
	},
	velocity0: {
		unit: "rad/s",
		least: -100,
		most: 100
	},
	length: {
		unit: "m",
		least: .001,
		most: 1e3
	},
	gravity: {
		unit: "m/s2",
		least: .001,
		most: 1e3
	},
	t: {
		unit: "s",
		least: 0,
		most: 1e5
	},
	speed: {
		unit: "",
		least: .01,
		most: 10
	},
	span: {
		unit: "s",
		least: .1,
		most: 600
	},
	seed: {
		unit: "",
		least: 1,
		most: 999999
	},
	p: {
		unit: "",
		least: -1e6,
		most: 1e6
	},
	r: {
		unit: "",
		least: -1e6,
		most: 1e6
	},
	q: {
		unit: "",
		least: -1e6,
		most: 1e6
	},
	c: {
		unit: "",
		least: -1e6,
		most: 1e6
	},
	s: {
		unit: "",
		least: -1e6,
		most: 1e6
	},
	u0: {
		unit: "",
		least: -1e3,
		most: 1e3
	},
	springVelocity0: {
		unit: "",
		least: -1e6,
		most: 1e6
	},
	linear: {
		unit: "1/s",
		least: 0,
		most: 100
	},
	quadratic: {
		unit: "1/rad",
		least: 0,
		most: 100
	},
	dry: {
		unit: "rad/s2",
		least: 0,
		most: 1e3
	},
	torque: {
		unit: "rad/s2",
		least: -1e3,
		most: 1e3
	},
	drive: {
		unit: "rad/s2",
		least: 0,
		most: 1e3
	},
	driveFrequency: {
		unit: "rad/s",
		least: .01,
		most: 1e3
	},
	until: {
		unit: "s",
		least: 1,
		most: 600
	}
};
function N(e, t) {
	let n = M[e];
	return t >= n.least && t <= n.most;
}
function Dt(e) {
	let { argument: t } = A(e.name), n = e.argument;
	return !t || n === void 0 || (t.of === "step" || Number.isInteger(n)) && n >= t.least && n <= t.most ? null : {
		kind: "argument",
		value: j(e),
		least: t.least,
		most: t.most
	};
}
// src/language/en.ts
var Ot = {
	functionNames: {
		sin: "sin",
		tan: "tan"
	},
	machineAssisted: "",
	units: {
		"rad/s": "rad/s",
		m: "m",
		"m/s2": "m/s²",
		s: "s",
		kg: "kg",
		deg: "°",
		"1/s": "1/s",
		"1/rad": "1/rad",
		"rad/s2": "rad/s²",
		"": ""
	},
	shell: {
		title: "libration: the exact pendulum",
		skip: "Skip to the pendulum",
		views: "Views",
		more: "More",
		share: "Share",
		language: "Language",
		theme: "Theme",
		themes: {
			auto: "As the system",
			light: "Light",
			dark: "Dark"
		},
		keys: "Keys",
		menu: "Language, theme, keys",
		close: "Close",
		undo: "Undo",
		replaced: "Now showing: {name}."
	},
	views: {
		lab: "Lab",
		phase: "Phase portrait",
		period: "Period",
		functions: "Functions",
		derivation: "Derivation",
		springs: "Springs",
		friction: "Friction",
		data: "Data",
		handouts: "Hand-outs"
	},
	viewsShort: {
		lab: "Lab",
		phase: "Phase",
		period: "Period",
		functions: "Functions",
		derivation: "Derivation",
		springs: "Springs",
		friction: "Friction",
		data: "Data",
		handouts: "Hand-outs"
	},
	sentence: {
		swings: "Released at *{angle}*, the pendulum swings once in *{period}*: *{longer}* longer than a small swing.",
		swingsThrown: "Started at *{angle}* with *{velocity}*, the pendulum swings to *{top}* and back in *{period}*: *{longer}* longer than a small swing.",
		rotates: "Thrown from *{angle}* at *{velocity}*, it turns over once in *{period}*.",
		separatrix: "From *{angle}* at *{velocity}* it climbs to the top and *never arrives*. Its period is infinite.",
		balance: "At rest at *180°*: unstable balance. It stays.",
		rest: "At rest at *{angle}*.",
		waiting: "The exact pendulum, in your hand."
	},
	values: {
		theta0: {
			label: "Release angle",
			symbol: "_θ_{0}"
		},
		velocity0: {
			label: "Start velocity",
			symbol: "_θ'_{0}"
		},
		length: {
			label: "Length",
			symbol: "_L_"
		},
		gravity: {
			label: "Gravity",
			symbol: "_g_"
		},
		t: {
			label: "Time",
			symbol: "_t_"
		},
		span: {
			label: "Seconds shown",
			symbol: ""
		}
	},
	faults: {
		"not-a-number": "{name}: “{value}” is not a number. The motion still shows {kept}.",
		"out-of-range": "{name}: {value} is outside {least} to {most}. The motion still shows {kept}."
	},
	linkFaults: {
		intro: "This link has a value that cannot be:",
		introMany: "This link has values that cannot be:",
		"not-a-number": "*{name}={value}* is not a number. {kept} is shown instead.",
		"out-of-range": "*{name}={value}* is outside {least} to {most}. {kept} is shown instead.",
		"not-one-of": "*{name}={value}* is not one of {allowed}. {kept} is shown instead.",
		argument: "*{value}* needs a number from {least} to {most}. The usual curves are shown instead.",
		"too-many": "*{name}*: {value} are too many; {most} can be drawn. {kept} is shown instead.",
		"not-whole": "*{name}={value}* is not a whole number. {kept} is shown instead.",
		unknown: "*{name}={value}* is not known here. It is left as it is in the link.",
		"unknown-curve": "*{value}* is not a curve that is known here. The usual curves are shown instead.",
		twice: "*{name}* stands there twice; *{value}* is not used.",
		usual: "The usual value",
		kept: "The rest of the link holds."
	},
	embedding: {
		locked: "Locked by the sender.",
		hidden: "hidden",
		hiddenTitle: "Hidden by the sender: measure it.",
		sentence: "*_g_* is hidden here. Measure it with the pendulum."
	},
	drawing: {
		name: "The pendulum",
		bob: "Bob",
		bobText: "{angle} degrees, release angle",
		energy: "energy",
		kinetic: "kinetic",
		potential: "potential",
		more: "energy {percent}",
		caption: "At {t} the bob is at {angle} with {velocity}. Kinetic {kinetic}, potential {potential} of the energy at the top."
	},
	facts: {
		period: "Period _T_",
		turn: "Time of a turn _T_",
		smallPeriod: "small-swing period _T_{0}",
		ratio: "ratio _T_/_T_{0}",
		parameter: "parameter",
		parameterIs: "_m_ = sin²(_θ_{0}/2)",
		energyIs: "_m_ = _E_/_E_{top}",
		infinite: "infinite",
		none: "–"
	},
	hints: {
		parameter: "The parameter m of the elliptic functions: the energy as a part of the energy at the top. Released from rest it is sin²(θ₀/2); above 1 the pendulum turns over.",
		modulus: "The modulus k is the square root of the parameter m. Many programs ask for m, some for k: check which.",
		separatrix: "The separatrix is the motion with exactly the energy of the top. It parts swinging from turning over, and its period is infinite.",
		stated: "The range of angles for which its author offers the formula."
	},
	plots: {
		angle: "Angle",
		velocity: "Velocity",
		angleTitle: "Angle _θ_",
		velocityTitle: "Velocity _θ'_",
		velocityUnit: "rad/s",
		error: "Error",
		errorPercent: "formula − exact, % of {angle}",
		errorDegrees: "formula − exact, in degrees",
		log: "log",
		linear: "linear",
		unit: "Unit of the error",
		percentName: "per cent of the amplitude",
		degreesName: "degrees",
		totalTitle: "Total energy",
		partsTitle: "Energy",
		energyUnit: "% of the energy at the top",
		total: "Total",
		parts: "Parts",
		kinetic: "kinetic",
		potential: "potential",
		sum: "sum",
		top: "the top",
		period: "_T_",
		shows: "What the plot shows",
		axis: "Error axis",
		table: "Data table of {plot}",
		listen: "Listen to {plot}",
		stop: "Stop the sound of {plot}",
		save: "Save: {plot}",
		now: "Time in the plot of {plot}",
		loading: "Loading the exact core …",
		loadingView: "Loading the view …",
		failedView: "This view could not be loaded. The Lab works; load the page again for the others.",
		empty: "Only the exact motion is drawn. {add} to see its error.",
		emptyAdd: "Add a curve",
		hatched: "Hatched: {reasons}",
		captionAngle: "The angle from {from} to {to}. The exact motion is between {least} and {most}.",
		captionVelocity: "The velocity from {from} to {to}. The exact motion is between {least} and {most}.",
		captionError: "Largest errors from {from} to {to}: {errors}.",
		captionErrorOne: "{name} {error} at {t}",
		captionEnergy: "The exact energy is {energy} of the energy at the top.",
		captionDrift: "With {name} it is between {least} and {most}.",
		caption: "The plot, in words"
	},
	portrait: {
		title: "Phase portrait",
		unit: "_θ'_ in rad/s",
		open: "Open the phase portrait",
		swings: "swings",
		turnsOver: "turns over",
		caption: "Velocity against angle: the orbit of this motion, and the separatrix between swinging and turning over."
	},
	compare: {
		title: "Compare",
		curve: "curve",
		largest: "largest error, {from}–{to} {unit}",
		largestPeriod: "largest error over 1 _T_",
		exact: "exact",
		exactBy: "Jacobi’s sn",
		add: "Add a curve",
		convergence: "Error against step",
		examples: "Examples",
		hatched: "hatched",
		remove: "Remove {name}",
		fewer: "Fewer terms of {name}",
		moreTerms: "More terms of {name}",
		shorter: "Shorter step of {name}",
		longer: "Longer step of {name}",
		step: "step {step}",
		full: "Six curves are drawn. Switch one off to draw another.",
		refused: "not for this motion",
		stated: "stated up to {range}",
		overTop: "over the top at {t}",
		none: "–"
	},
	curves: {
		linear: {
			name: "linear",
			what: "small swings, sin _θ_ = _θ_"
		},
		harmonic: {
			name: "harmonic",
			what: "cosine with exact period"
		},
		fourier: {
			name: "Fourier _N_",
			what: "terms; Lima 2019 (22)"
		},
		"fourier-theta": {
			name: "series of _θ_",
			what: "terms; Jacobi, integrated"
		},
		trigonometric: {
			name: "trigonometric",
			what: "Salas 2019 (35)"
		},
		"small-m": {
			name: "small _m_",
			what: "Salas 2019, before fig. 6"
		},
		"small-m-bounded": {
			name: "small _m_, bounded",
			what: "Salas 2019 (23), first order"
		},
		cubic: {
			name: "cubic",
			what: "sin _θ_ = _θ_ − 40_θ_³/243"
		},
		"cubic-quintic": {
			name: "cubic-quintic",
			what: "Salas 2019 (3), with _θ_⁵/131"
		},
		taylor: {
			name: "Taylor",
			what: "degree; polynomial about 0"
		},
		rk45: {
			name: "RK45",
			what: "SciPy’s default settings"
		},
		rk4: {
			name: "RK4",
			what: "step in s; order 4"
		},
		verlet: {
			name: "Verlet",
			what: "step in s; leapfrog, order 2"
		},
		"euler-cromer": {
			name: "Euler–Cromer",
			what: "step in s; order 1, energy stays near"
		},
		euler: {
			name: "Euler",
			what: "step in s; order 1"
		}
	},
	reasons: {
		fourier: "{name}: undefined above {angle}, where the terms of (22) make sin(_θ_/2) larger than 1.",
		cubic: "{name}: beyond the top of its own force it leaves to infinity.",
		rotation: "It is written for swings; this turns over.",
		separatrix: "It needs a period; this motion has none.",
		start: "It is not written for this start.",
		loading: "The module of this formula is not loaded.",
		none: "{name}: no value here.",
		steps: "Too many steps: show less time, or take longer steps."
	},
	play: {
		play: "Play",
		pause: "Pause",
		back: "Step back",
		on: "Step on",
		speed: "Speed",
		shown: "Shown",
		period: "1 _T_",
		other: "Another span",
		timeText: "{t} seconds",
		reduced: "paused, as your system asks",
		bar: "Time"
	},
	alarms: { overTop: "{name} over the top at {t}" },
	table: {
		caption: "{plot}, {unit}.",
		csv: "CSV",
		all: "all {count} rows",
		some: "fewer rows",
		time: "_t_, s",
		decimalPoint: "decimal point, columns separated by commas",
		decimalComma: "decimal comma, columns separated by semicolons",
		noValue: "no value"
	},
	examples: {
		lima2: "Lima, figure 2: 60°",
		lima3: "Lima, figure 3: 90°",
		lima4: "Lima, figure 4: 157.5°",
		horsley: "Horsley: 3 rad, and RK45",
		salas: "Salas: m = 1.419",
		over: "Over the top",
		balance: "At rest at 180°"
	},
	messages: {
		noWasm: "This browser does not start WebAssembly, so nothing can be computed here. {table} needs none.",
		failed: "The exact core did not start: {why}. {offline} may work. {table} needs no core.",
		offline: "The offline file",
		periodTable: "The table of periods",
		close: "Close this message"
	}
}, kt = {
	functionNames: {
		sin: "sen",
		tan: "tan"
	},
	machineAssisted: "traducción automática",
	units: Ot.units,
	shell: {
		title: "libration: el péndulo exacto",
		skip: "Ir al péndulo",
		views: "Vistas",
		more: "Más",
		share: "Compartir",
		language: "Idioma",
		theme: "Tema",
		themes: {
			auto: "Como el sistema",
			light: "Claro",
			dark: "Oscuro"
		},
		keys: "Teclas",
		menu: "Idioma, tema, teclas",
		close: "Cerrar",
		undo: "Deshacer",
		replaced: "Se muestra ahora: {name}."
	},
	views: {
		lab: "Laboratorio",
		phase: "Retrato de fases",
		period: "Periodo",
		functions: "Funciones",
		derivation: "Deducción",
		springs: "Resortes",
		friction: "Fricción",
		data: "Datos",
		handouts: "Hojas"
	},
	viewsShort: {
		lab: "Lab",
		phase: "Fases",
		period: "Periodo",
		functions: "Funciones",
		derivation: "Deducción",
		springs: "Resortes",
		friction: "Fricción",
		data: "Datos",
		handouts: "Hojas"
	},
	sentence: {
		swings: "Soltado a *{angle}*, el péndulo oscila una vez en *{period}*: *{longer}* más que una oscilación pequeña.",
		swingsThrown: "Desde *{angle}* con *{velocity}*, el péndulo llega a *{top}* y vuelve en *{period}*: *{longer}* más que una oscilación pequeña.",
		rotates: "Lanzado desde *{angle}* a *{velocity}*, da una vuelta completa en *{period}*.",
		separatrix: "Desde *{angle}* a *{velocity}* sube hasta lo alto y *nunca llega*. Su periodo es infinito.",
		balance: "En reposo a *180°*: equilibrio inestable. Se queda.",
		rest: "En reposo a *{angle}*.",
		waiting: "El péndulo exacto, en su mano."
	},
	values: {
		theta0: {
			label: "Ángulo inicial",
			symbol: "_θ_{0}"
		},
		velocity0: {
			label: "Velocidad inicial",
			symbol: "_θ'_{0}"
		},
		length: {
			label: "Longitud",
			symbol: "_L_"
		},
		gravity: {
			label: "Gravedad",
			symbol: "_g_"
		},
		t: {
			label: "Tiempo",
			symbol: "_t_"
		},
		span: {
			label: "Segundos mostrados",
			symbol: ""
		}
	},
	faults: {
		"not-a-number": "{name}: «{value}» no es un número. El movimiento aún muestra {kept}.",
		"out-of-range": "{name}: {value} está fuera de {least} a {most}. El movimiento aún muestra {kept}."
	},
	linkFaults: {
		intro: "Este enlace tiene un valor que no puede ser:",
		introMany: "Este enlace tiene valores que no pueden ser:",
		"not-a-number": "*{name}={value}* no es un número. Se muestra {kept}.",
		"out-of-range": "*{name}={value}* está fuera de {least} a {most}. Se muestra {kept}.",
		"not-one-of": "*{name}={value}* no es uno de {allowed}. Se muestra {kept}.",
		argument: "*{value}* necesita un número de {least} a {most}. Se muestran las curvas usuales.",
		"too-many": "*{name}*: {value} son demasiados; caben {most}. Se muestra {kept}.",
		"not-whole": "*{name}={value}* no es un número entero. {kept} se muestra en su lugar.",
		unknown: "*{name}={value}* no se conoce aquí. Queda en el enlace como está.",
		"unknown-curve": "*{value}* no es una curva conocida aquí. Se muestran las curvas usuales.",
		twice: "*{name}* está dos veces; *{value}* no se usa.",
		usual: "el valor usual",
		kept: "El resto del enlace vale."
	},
	embedding: {
		locked: "Bloqueado por quien lo envía.",
		hidden: "oculta",
		hiddenTitle: "Oculta por quien la envía: mídala.",
		sentence: "*_g_* está oculta aquí. Mídala con el péndulo."
	},
	drawing: {
		name: "El péndulo",
		bob: "Masa del péndulo",
		bobText: "{angle} grados, ángulo inicial",
		energy: "energía",
		kinetic: "cinética",
		potential: "potencial",
		more: "energía {percent}",
		caption: "En {t} la masa está a {angle} con {velocity}. Cinética {kinetic}, potencial {potential} de la energía en lo alto."
	},
	facts: {
		period: "Periodo _T_",
		turn: "Tiempo de una vuelta _T_",
		smallPeriod: "de oscilaciones pequeñas _T_{0}",
		ratio: "razón _T_/_T_{0}",
		parameter: "parámetro",
		parameterIs: "_m_ = sin²(_θ_{0}/2)",
		energyIs: "_m_ = _E_/_E_{alto}",
		infinite: "infinito",
		none: "–"
	},
	hints: {
		parameter: "El parámetro m de las funciones elípticas: la energía como parte de la energía en lo alto. Soltado del reposo es sin²(θ₀/2); por encima de 1 el péndulo da vueltas.",
		modulus: "El módulo k es la raíz del parámetro m. Muchos programas piden m, algunos k: compruebe cuál.",
		separatrix: "La separatriz es el movimiento con exactamente la energía de lo alto. Separa las oscilaciones de las vueltas, y su periodo es infinito.",
		stated: "El intervalo de ángulos para el que su autor propone la fórmula."
	},
	plots: {
		angle: "Ángulo",
		velocity: "Velocidad",
		angleTitle: "Ángulo _θ_",
		velocityTitle: "Velocidad _θ'_",
		velocityUnit: "rad/s",
		error: "Error",
		errorPercent: "fórmula − exacto, % de {angle}",
		errorDegrees: "fórmula − exacto, en grados",
		log: "log",
		linear: "lineal",
		unit: "Unidad del error",
		percentName: "por ciento de la amplitud",
		degreesName: "grados",
		totalTitle: "Energía total",
		partsTitle: "Energía",
		energyUnit: "% de la energía en lo alto",
		total: "Total",
		parts: "Partes",
		kinetic: "cinética",
		potential: "potencial",
		sum: "suma",
		top: "lo alto",
		period: "_T_",
		shows: "Lo que muestra la gráfica",
		axis: "Eje del error",
		table: "Tabla de datos: {plot}",
		listen: "Escuchar: {plot}",
		stop: "Parar el sonido: {plot}",
		save: "Guardar: {plot}",
		now: "Tiempo en la gráfica: {plot}",
		loading: "Cargando el núcleo exacto …",
		loadingView: "Cargando la vista …",
		failedView: "Esta vista no se pudo cargar. El Lab funciona; recargue la página para las otras.",
		empty: "Solo está dibujado el movimiento exacto. {add} para ver su error.",
		emptyAdd: "Añada una curva",
		hatched: "Rayado: {reasons}",
		captionAngle: "El ángulo de {from} a {to}. El movimiento exacto está entre {least} y {most}.",
		captionVelocity: "La velocidad de {from} a {to}. El movimiento exacto está entre {least} y {most}.",
		captionError: "Errores mayores de {from} a {to}: {errors}.",
		captionErrorOne: "{name} {error} en {t}",
		captionEnergy: "La energía exacta es {energy} de la energía en lo alto.",
		captionDrift: "Con {name} está entre {least} y {most}.",
		caption: "La gráfica en palabras"
	},
	portrait: {
		title: "Retrato de fases",
		unit: "_θ'_ en rad/s",
		open: "Abrir el retrato de fases",
		swings: "oscila",
		turnsOver: "da vueltas",
		caption: "Velocidad contra ángulo: la órbita de este movimiento y la separatriz entre oscilaciones y vueltas."
	},
	compare: {
		title: "Comparar",
		curve: "curva",
		largest: "error mayor, {from}–{to} {unit}",
		largestPeriod: "error mayor en 1 _T_",
		exact: "exacto",
		exactBy: "sn de Jacobi",
		add: "Añadir curva",
		convergence: "Error y paso",
		examples: "Ejemplos",
		hatched: "rayado",
		remove: "Quitar {name}",
		fewer: "Menos términos de {name}",
		moreTerms: "Más términos de {name}",
		shorter: "Paso menor de {name}",
		longer: "Paso mayor de {name}",
		step: "paso {step}",
		full: "Hay seis curvas dibujadas. Apague una para dibujar otra.",
		refused: "no sirve para este movimiento",
		stated: "propuesta hasta {range}",
		overTop: "pasa por lo alto en {t}",
		none: "–"
	},
	curves: {
		linear: {
			name: "lineal",
			what: "oscilaciones pequeñas"
		},
		harmonic: {
			name: "armónica",
			what: "coseno, periodo exacto"
		},
		fourier: {
			name: "Fourier _N_",
			what: "términos; Lima 2019 (22)"
		},
		"fourier-theta": {
			name: "serie de _θ_",
			what: "términos; Jacobi, integrada"
		},
		trigonometric: {
			name: "trigonométrica",
			what: "Salas 2019 (35)"
		},
		"small-m": {
			name: "_m_ pequeño",
			what: "Salas 2019, antes de la fig. 6"
		},
		"small-m-bounded": {
			name: "_m_ pequeño, acotada",
			what: "Salas 2019 (23), primer orden"
		},
		cubic: {
			name: "cúbica",
			what: "sin _θ_ = _θ_ − 40_θ_³/243"
		},
		"cubic-quintic": {
			name: "cúbica-quíntica",
			what: "Salas 2019 (3), con _θ_⁵/131"
		},
		taylor: {
			name: "Taylor",
			what: "grado; polinomio alrededor de 0"
		},
		rk45: {
			name: "RK45",
			what: "SciPy sin ajustes"
		},
		rk4: {
			name: "RK4",
			what: "paso en s; orden 4"
		},
		verlet: {
			name: "Verlet",
			what: "paso en s; leapfrog, orden 2"
		},
		"euler-cromer": {
			name: "Euler–Cromer",
			what: "paso en s; orden 1, energía casi constante"
		},
		euler: {
			name: "Euler",
			what: "paso en s; orden 1"
		}
	},
	reasons: {
		fourier: "{name}: sin valor por encima de {angle}, donde los términos de (22) hacen sin(_θ_/2) mayor que 1.",
		cubic: "{name}: más allá de lo alto de su propia fuerza se va al infinito.",
		rotation: "Está escrita para oscilaciones; este da vueltas.",
		separatrix: "Necesita un periodo; este movimiento no lo tiene.",
		start: "No está escrita para este inicio.",
		loading: "El módulo de esta fórmula no está cargado.",
		none: "{name}: sin valor aquí.",
		steps: "Demasiados pasos: muestre menos tiempo o tome pasos más largos."
	},
	play: {
		play: "Reproducir",
		pause: "Pausa",
		back: "Un paso atrás",
		on: "Un paso adelante",
		speed: "Ritmo",
		shown: "Mostrar",
		period: "1 _T_",
		other: "Otra duración",
		timeText: "{t} segundos",
		reduced: "en pausa, como pide el sistema",
		bar: "Tiempo"
	},
	alarms: { overTop: "{name} pasa por lo alto en {t}" },
	table: {
		caption: "{plot}, {unit}.",
		csv: "CSV",
		all: "las {count} filas",
		some: "menos filas",
		time: "_t_, s",
		decimalPoint: "punto decimal, columnas separadas por comas",
		decimalComma: "coma decimal, columnas separadas por punto y coma",
		noValue: "sin valor"
	},
	examples: {
		lima2: "Lima, figura 2: 60°",
		lima3: "Lima, figura 3: 90°",
		lima4: "Lima, figura 4: 157,5°",
		horsley: "Horsley: 3 rad, y RK45",
		salas: "Salas: m = 1,419",
		over: "Por encima de lo alto",
		balance: "En reposo a 180°"
	},
	messages: {
		noWasm: "Este navegador no arranca WebAssembly, así que aquí no se puede calcular nada. {table} no lo necesita.",
		failed: "El núcleo exacto no arrancó: {why}. {offline} quizá funcione. {table} no lo necesita.",
		offline: "El archivo sin conexión",
		periodTable: "La tabla de periodos",
		close: "Cerrar este mensaje"
	}
}, At = {
	en: Ot,
	"pt-BR": {
		functionNames: {
			sin: "sen",
			tan: "tg"
		},
		machineAssisted: "tradução automática",
		units: Ot.units,
		shell: {
			title: "libration: o pêndulo exato",
			skip: "Ir ao pêndulo",
			views: "Vistas",
			more: "Mais",
			share: "Compartilhar",
			language: "Idioma",
			theme: "Tema",
			themes: {
				auto: "Como no sistema",
				light: "Claro",
				dark: "Escuro"
			},
			keys: "Teclas",
			menu: "Idioma, tema, teclas",
			close: "Fechar",
			undo: "Desfazer",
			replaced: "Mostrando agora: {name}."
		},
		views: {
			lab: "Laboratório",
			phase: "Retrato de fase",
			period: "Período",
			functions: "Funções",
			derivation: "Dedução",
			springs: "Molas",
			friction: "Atrito",
			data: "Dados",
			handouts: "Folhas"
		},
		viewsShort: {
			lab: "Lab",
			phase: "Fase",
			period: "Período",
			functions: "Funções",
			derivation: "Dedução",
			springs: "Molas",
			friction: "Atrito",
			data: "Dados",
			handouts: "Folhas"
		},
		sentence: {
			swings: "Solto a *{angle}*, o pêndulo oscila uma vez em *{period}*: *{longer}* mais que uma oscilação pequena.",
			swingsThrown: "Partindo de *{angle}* com *{velocity}*, o pêndulo vai até *{top}* e volta em *{period}*: *{longer}* mais que uma oscilação pequena.",
			rotates: "Lançado de *{angle}* a *{velocity}*, dá uma volta completa em *{period}*.",
			separatrix: "De *{angle}* a *{velocity}* ele sobe até o topo e *nunca chega*. Seu período é infinito.",
			balance: "Em repouso a *180°*: equilíbrio instável. Ele fica.",
			rest: "Em repouso a *{angle}*.",
			waiting: "O pêndulo exato, na sua mão."
		},
		values: {
			theta0: {
				label: "Ângulo inicial",
				symbol: "_θ_{0}"
			},
			velocity0: {
				label: "Velocidade inicial",
				symbol: "_θ'_{0}"
			},
			length: {
				label: "Comprimento",
				symbol: "_L_"
			},
			gravity: {
				label: "Gravidade",
				symbol: "_g_"
			},
			t: {
				label: "Tempo",
				symbol: "_t_"
			},
			span: {
				label: "Segundos mostrados",
				symbol: ""
			}
		},
		faults: {
			"not-a-number": "{name}: “{value}” não é um número. O movimento ainda mostra {kept}.",
			"out-of-range": "{name}: {value} está fora de {least} a {most}. O movimento ainda mostra {kept}."
		},
		linkFaults: {
			intro: "Este link tem um valor que não pode ser:",
			introMany: "Este link tem valores que não podem ser:",
			"not-a-number": "*{name}={value}* não é um número. Mostra-se {kept}.",
			"out-of-range": "*{name}={value}* está fora de {least} a {most}. Mostra-se {kept}.",
			"not-one-of": "*{name}={value}* não é um de {allowed}. Mostra-se {kept}.",
			argument: "*{value}* precisa de um número de {least} a {most}. Mostram-se as curvas usuais.",
			"too-many": "*{name}*: {value} são demais; cabem {most}. Mostra-se {kept}.",
			"not-whole": "*{name}={value}* não é um número inteiro. {kept} é mostrado em seu lugar.",
			unknown: "*{name}={value}* não é conhecido aqui. Fica no link como está.",
			"unknown-curve": "*{value}* não é uma curva conhecida aqui. Mostram-se as curvas usuais.",
			twice: "*{name}* aparece duas vezes; *{value}* não é usado.",
			usual: "o valor usual",
			kept: "O resto do link vale."
		},
		embedding: {
			locked: "Bloqueado por quem enviou.",
			hidden: "oculta",
			hiddenTitle: "Oculta por quem enviou: meça-a.",
			sentence: "*_g_* está oculta aqui. Meça-a com o pêndulo."
		},
		drawing: {
			name: "O pêndulo",
			bob: "Massa do pêndulo",
			bobText: "{angle} graus, ângulo inicial",
			energy: "energia",
			kinetic: "cinética",
			potential: "potencial",
			more: "energia {percent}",
			caption: "Em {t} a massa está a {angle} com {velocity}. Cinética {kinetic}, potencial {potential} da energia no topo."
		},
		facts: {
			period: "Período _T_",
			turn: "Tempo de uma volta _T_",
			smallPeriod: "de oscilações pequenas _T_{0}",
			ratio: "razão _T_/_T_{0}",
			parameter: "parâmetro",
			parameterIs: "_m_ = sin²(_θ_{0}/2)",
			energyIs: "_m_ = _E_/_E_{topo}",
			infinite: "infinito",
			none: "–"
		},
		hints: {
			parameter: "O parâmetro m das funções elípticas: a energia como parte da energia no topo. Solto do repouso, é sin²(θ₀/2); acima de 1 o pêndulo dá voltas.",
			modulus: "O módulo k é a raiz do parâmetro m. Muitos programas pedem m, alguns pedem k: verifique qual.",
			separatrix: "A separatriz é o movimento com exatamente a energia do topo. Ela separa as oscilações das voltas, e seu período é infinito.",
			stated: "O intervalo de ângulos para o qual o autor propõe a fórmula."
		},
		plots: {
			angle: "Ângulo",
			velocity: "Velocidade",
			angleTitle: "Ângulo _θ_",
			velocityTitle: "Velocidade _θ'_",
			velocityUnit: "rad/s",
			error: "Erro",
			errorPercent: "fórmula − exato, % de {angle}",
			errorDegrees: "fórmula − exato, em graus",
			log: "log",
			linear: "linear",
			unit: "Unidade do erro",
			percentName: "por cento da amplitude",
			degreesName: "graus",
			totalTitle: "Energia total",
			partsTitle: "Energia",
			energyUnit: "% da energia no topo",
			total: "Total",
			parts: "Partes",
			kinetic: "cinética",
			potential: "potencial",
			sum: "soma",
			top: "o topo",
			period: "_T_",
			shows: "O que o gráfico mostra",
			axis: "Eixo do erro",
			table: "Tabela de dados: {plot}",
			listen: "Ouvir: {plot}",
			stop: "Parar o som: {plot}",
			save: "Salvar: {plot}",
			now: "Tempo no gráfico: {plot}",
			loading: "Carregando o núcleo exato …",
			loadingView: "Carregando a vista …",
			failedView: "Esta vista não pôde ser carregada. O Lab funciona; recarregue a página para as outras.",
			empty: "Só o movimento exato está desenhado. {add} para ver o erro.",
			emptyAdd: "Adicione uma curva",
			hatched: "Hachurado: {reasons}",
			captionAngle: "O ângulo de {from} a {to}. O movimento exato fica entre {least} e {most}.",
			captionVelocity: "A velocidade de {from} a {to}. O movimento exato fica entre {least} e {most}.",
			captionError: "Maiores erros de {from} a {to}: {errors}.",
			captionErrorOne: "{name} {error} em {t}",
			captionEnergy: "A energia exata é {energy} da energia no topo.",
			captionDrift: "Com {name} ela fica entre {least} e {most}.",
			caption: "O gráfico em palavras"
		},
		portrait: {
			title: "Retrato de fase",
			unit: "_θ'_ em rad/s",
			open: "Abrir o retrato de fase",
			swings: "oscila",
			turnsOver: "dá voltas",
			caption: "Velocidade contra ângulo: a órbita deste movimento e a separatriz entre oscilações e voltas."
		},
		compare: {
			title: "Comparar",
			curve: "curva",
			largest: "maior erro, {from}–{to} {unit}",
			largestPeriod: "maior erro em 1 _T_",
			exact: "exato",
			exactBy: "sn de Jacobi",
			add: "Adicionar curva",
			convergence: "Erro e passo",
			examples: "Exemplos",
			hatched: "hachurado",
			remove: "Remover {name}",
			fewer: "Menos termos de {name}",
			moreTerms: "Mais termos de {name}",
			shorter: "Passo menor de {name}",
			longer: "Passo maior de {name}",
			step: "passo {step}",
			full: "Seis curvas estão desenhadas. Desligue uma para desenhar outra.",
			refused: "não serve a este movimento",
			stated: "proposta até {range}",
			overTop: "passa pelo topo em {t}",
			none: "–"
		},
		curves: {
			linear: {
				name: "linear",
				what: "oscilações pequenas"
			},
			harmonic: {
				name: "harmônica",
				what: "cosseno, período exato"
			},
			fourier: {
				name: "Fourier _N_",
				what: "termos; Lima 2019 (22)"
			},
			"fourier-theta": {
				name: "série de _θ_",
				what: "termos; Jacobi, integrada"
			},
			trigonometric: {
				name: "trigonométrica",
				what: "Salas 2019 (35)"
			},
			"small-m": {
				name: "_m_ pequeno",
				what: "Salas 2019, antes da fig. 6"
			},
			"small-m-bounded": {
				name: "_m_ pequeno, limitada",
				what: "Salas 2019 (23), 1ª ordem"
			},
			cubic: {
				name: "cúbica",
				what: "sin _θ_ = _θ_ − 40_θ_³/243"
			},
			"cubic-quintic": {
				name: "cúbica-quíntica",
				what: "Salas 2019 (3), com _θ_⁵/131"
			},
			taylor: {
				name: "Taylor",
				what: "grau; polinômio em torno de 0"
			},
			rk45: {
				name: "RK45",
				what: "SciPy sem ajustes"
			},
			rk4: {
				name: "RK4",
				what: "passo em s; ordem 4"
			},
			verlet: {
				name: "Verlet",
				what: "passo em s; leapfrog, ordem 2"
			},
			"euler-cromer": {
				name: "Euler–Cromer",
				what: "passo em s; ordem 1, energia quase constante"
			},
			euler: {
				name: "Euler",
				what: "passo em s; ordem 1"
			}
		},
		reasons: {
			fourier: "{name}: sem valor acima de {angle}, onde os termos de (22) tornam sin(_θ_/2) maior que 1.",
			cubic: "{name}: além do topo da sua própria força ela vai ao infinito.",
			rotation: "É escrita para oscilações; este dá voltas.",
			separatrix: "Precisa de um período; este movimento não tem.",
			start: "Não é escrita para este início.",
			loading: "O módulo desta fórmula não está carregado.",
			none: "{name}: sem valor aqui.",
			steps: "Passos demais: mostre menos tempo ou tome passos maiores."
		},
		play: {
			play: "Tocar",
			pause: "Pausar",
			back: "Um passo atrás",
			on: "Um passo à frente",
			speed: "Ritmo",
			shown: "Mostrar",
			period: "1 _T_",
			other: "Outra duração",
			timeText: "{t} segundos",
			reduced: "pausado, como pede o sistema",
			bar: "Tempo"
		},
		alarms: { overTop: "{name} passa pelo topo em {t}" },
		table: {
			caption: "{plot}, {unit}.",
			csv: "CSV",
			all: "todas as {count} linhas",
			some: "menos linhas",
			time: "_t_, s",
			decimalPoint: "ponto decimal, colunas separadas por vírgulas",
			decimalComma: "vírgula decimal, colunas separadas por ponto e vírgula",
			noValue: "sem valor"
		},
		examples: {
			lima2: "Lima, figura 2: 60°",
			lima3: "Lima, figura 3: 90°",
			lima4: "Lima, figura 4: 157,5°",
			horsley: "Horsley: 3 rad, e RK45",
			salas: "Salas: m = 1,419",
			over: "Por cima do topo",
			balance: "Em repouso a 180°"
		},
		messages: {
			noWasm: "Este navegador não inicia WebAssembly, e nada pode ser calculado aqui. {table} não precisa dele.",
			failed: "O núcleo exato não iniciou: {why}. {offline} talvez funcione. {table} não precisa dele.",
			offline: "O arquivo offline",
			periodTable: "A tabela de períodos",
			close: "Fechar esta mensagem"
		}
	},
	es: kt
};
function jt(e) {
	for (let t of e) {
		let e = t.toLowerCase().split("-")[0], n = mt.find((t) => t.toLowerCase().split("-")[0] === e);
		if (n) return n;
	}
	return "en";
}
var Mt = class {
	language;
	say;
	#e = /* @__PURE__ */ new Map();
	constructor(e) {
		this.language = e, this.say = At[e];
	}
	fill(e, t) {
		return Ue(e, t);
	}
	#t(e) {
		let t = JSON.stringify(e), n = this.#e.get(t);
		return n || (n = new Intl.NumberFormat(this.language, {
			useGrouping: !1,
			...e
		}), this.#e.set(t, n)), n;
	}
	fixed(e, t) {
		if (Number.isNaN(e)) return "–";
		if (!Number.isFinite(e)) return e > 0 ? "∞" : "−∞";
		let n = this.#t({
			minimumFractionDigits: t,
			maximumFractionDigits: t
		}).format(e);
		return /[1-9]/.test(n) ? n.replace("-", "−") : n.replace("-", "");
	}
	significant(e, t = 3) {
		if (e === 0) return "0";
		if (!Number.isFinite(e)) return this.fixed(e, 0);
		let n = Math.abs(Number(e.toPrecision(t))), r = Math.floor(Math.log10(n));
		return r < -4 || r > 4 ? this.#n(this.fixed(e / 10 ** r, t - 1), r) : this.fixed(e, Math.max(t - 1 - r, 0));
	}
	given(e) {
		let [t = "", n] = nt(e).split("e"), r = t.replace("-", "−").replace(".", this.decimal);
		return n ? this.#n(r, Number(n)) : r;
	}
	#n(e, t) {
		return `${e}\u00a0×\u00a010^{${String(t).replace("-", "−")}}`;
	}
	typed(e) {
		return nt(e).replace("-", "−").replace(".", this.decimal);
	}
	get decimal() {
		return this.language === "en" ? "." : ",";
	}
	angle(e, t) {
		let n = O(e);
		return `${t === void 0 ? this.given(n) : this.fixed(n, t)}°`;
	}
	shortAngle(e) {
		let t = O(e), n = (e) => Math.abs(e * 1e3 - Math.round(e * 1e3)) < 1e-9;
		return !n(t) && n(e) ? this.with(this.given(e), "rad") : `${this.given(Number(t.toFixed(3)))}°`;
	}
	with(e, t) {
		return t === "°" ? `${e}°` : `${e}\u00a0${t}`;
	}
	degrees(e) {
		let t = this.significant(e);
		return t.includes("^") ? `${t}\u00a0°` : `${t}°`;
	}
	percent(e, t = 3) {
		return this.with(this.significant(e, t), "%");
	}
	formula(e) {
		return e.replace(/\b(arc)?(sin|tan)\b/g, (e, t, n) => (t ?? "") + this.say.functionNames[n]);
	}
}, Nt = ["lab", "data"], Pt = ["facts", "energy"];
function Ft(e) {
	return Nt.includes(e) || yt.includes(e) && !Pt.includes(e);
}
function It({ show: e, hide: t }) {
	let n = dt.filter((t) => e.includes(t)), r = e.length === 0 ? dt : n.length === 0 || Lt({ show: e }) ? ["lab", ...n] : n;
	return dt.filter((e) => r.includes(e) && (!t || Ft(e)));
}
function Lt({ show: e }) {
	return e.includes("lab") ? null : e.filter((e) => yt.includes(e)).join(" ") || null;
}
function Rt({ lock: e, hide: t }, n) {
	return e.some((e) => xt[e] === n) || t && n === "gravity";
}
function zt(e, t) {
	return t.view && !It(e).includes(t.view) ? !0 : Object.keys(t).some((n) => Rt(e, n) && !Object.is(t[n], e[n]));
}
var Bt = 6768574230984739381n;
function Vt(e) {
	let [t = 0n] = new BigUint64Array(Float64Array.of(e).buffer);
	return `~${(t ^ Bt).toString(36)}`;
}
function Ht(e) {
	if (!/^~[0-9a-z]{1,13}$/.test(e)) return NaN;
	let t = 0n;
	for (let n of e.slice(1)) t = 36n * t + BigInt(Number.parseInt(n, 36));
	return new Float64Array(BigUint64Array.of(t ^ Bt).buffer)[0];
}
// src/periods.ts
var P = (e, t) => t ? {
	clothes: e,
	orders: t
} : { clothes: e }, Ut = {
	linear: P("c-linear"),
	bernoulli: P("c-polynomial"),
	series: P("c-polynomial second", {
		least: 2,
		most: 200,
		step: 2,
		usual: 4
	}),
	denman: P("c-polynomial third"),
	"kidd-fogg": P("c-harmonic"),
	molina: P("c-harmonic second"),
	"ganley-parwani": P("c-fourier second"),
	"lima-arun": P("c-fourier"),
	agm: P("c-integrator second", {
		least: 1,
		most: 8,
		step: 1,
		usual: 1
	}),
	belendez: P("c-integrator"),
	cromer: P("c-euler"),
	chachiyo: P("c-euler second"),
	"salas-26": P("c-trigonometric second"),
	"salas-27": P("c-trigonometric"),
	"salas-28": P("c-trigonometric third")
}, Wt = Object.keys(Ut);
function Gt(e) {
	return Ut[e];
}
function Kt(e) {
	return Object.hasOwn(Ut, e);
}
function qt(e) {
	return e.split(":")[0];
}
function Jt(e) {
	let { orders: t } = Gt(e);
	return t ? `${e}:${t.usual}` : e;
}
function Yt(e) {
	let [t = "", n, ...r] = e.split(":");
	if (!Kt(t) || r.length > 0) return {
		kind: "not-one-of",
		name: "periods",
		value: e,
		allowed: Wt
	};
	let { orders: i } = Gt(t);
	if (n === void 0) return Jt(t);
	let a = Number(n);
	return i ? /^\d+$/.test(n) && a >= i.least && a <= i.most && (a - i.least) % i.step === 0 ? `${t}:${a}` : {
		kind: "argument",
		value: e,
		least: i.least,
		most: i.most
	} : {
		kind: "not-one-of",
		name: "periods",
		value: e,
		allowed: Wt
	};
}
// src/link.ts
var Xt = "1", Zt = (e) => typeof e == "object" && !!e && "kind" in e;
function F(e, t, n = !1) {
	return {
		of: e,
		read: (t, n) => {
			let r = E(t, M[e].unit);
			return Number.isNaN(r) ? {
				kind: "not-a-number",
				name: n,
				value: t
			} : N(e, r) ? r : {
				kind: "out-of-range",
				name: e,
				value: t
			};
		},
		write: t,
		always: n
	};
}
function I(e, t) {
	return {
		of: e,
		read: (e, n) => t.find((t) => t.toLowerCase() === e.toLowerCase()) ?? {
			kind: "not-one-of",
			name: n,
			value: e,
			allowed: t
		},
		write: (e) => String(e)
	};
}
function Qt(e, t = "1") {
	return {
		of: e,
		read: (e, n) => {
			let r = [t, "0"].indexOf(e);
			return r < 0 ? {
				kind: "not-one-of",
				name: n,
				value: e,
				allowed: [t, "0"]
			} : r === 0;
		},
		write: (e) => e ? t : "0"
	};
}
function $t(e, t) {
	return {
		of: e,
		read: (e, n) => {
			let r = e.split(",").filter((e) => e !== ""), i = r.find((e) => !t.includes(e));
			return i === void 0 ? t.filter((e) => r.includes(e)) : {
				kind: "not-one-of",
				name: n,
				value: i,
				allowed: t
			};
		},
		write: (e) => String(e)
	};
}
var en = ["angle", "velocity"], tn = (e, { quantity: t }) => [...t === "velocity" ? [t] : [], ...e].join(",");
function nn(e, t) {
	let n = e.startsWith("~") ? Ht(e) : NaN;
	return N("gravity", n) ? n : F("gravity", String).read(e, t);
}
function rn(e, t) {
	let n = T(e);
	return Number.isNaN(n) ? {
		kind: "not-a-number",
		name: t,
		value: e
	} : N("seed", n) ? Number.isInteger(n) ? n : {
		kind: "not-whole",
		name: t,
		value: e
	} : {
		kind: "out-of-range",
		name: "seed",
		value: e
	};
}
function an(e, t) {
	let [n = "", r, ...i] = e.split(":"), a = n === "solve_ivp" ? "rk45" : n;
	if (!lt(a) || i.length > 0) return {
		kind: "unknown",
		name: "curves",
		value: e
	};
	let o = {
		...ut(a),
		on: t
	};
	if (r === void 0) return o;
	if (!A(a).argument) return {
		kind: "unknown",
		name: "curves",
		value: e
	};
	let s = T(r);
	if (Number.isNaN(s)) return {
		kind: "not-a-number",
		name: a,
		value: r
	};
	let c = {
		...o,
		argument: s
	};
	return Dt(c) ?? c;
}
function on(e) {
	let t = [];
	for (let n of e.split(",").filter((e) => e !== "")) {
		let e = an(n.replace(/^!/, ""), !n.startsWith("!"));
		if (Zt(e)) return e;
		if (t.some((t) => j(t) === j(e))) return {
			kind: "twice",
			name: "curves",
			value: n
		};
		t.push(e);
	}
	let n = t.filter((e) => e.on).length;
	return n > 6 ? {
		kind: "too-many",
		name: "curves",
		value: String(n),
		most: 6
	} : t;
}
var sn = (e) => e.map((e) => (e.on ? "" : "!") + j(e)).join(",");
function cn(e) {
	let t = [];
	for (let n of e.split(",").filter((e) => e !== "")) {
		let [e = "", r = "0"] = n.split(";"), i = E(e, "deg"), a = E(r, "rad/s");
		if (Number.isNaN(i) || Number.isNaN(a)) return {
			kind: "not-a-number",
			name: "orbits",
			value: n
		};
		if (!N("theta0", i)) return {
			kind: "out-of-range",
			name: "theta0",
			value: e
		};
		if (!N("velocity0", a)) return {
			kind: "out-of-range",
			name: "velocity0",
			value: r
		};
		t.push({
			theta0: i,
			velocity0: a
		});
	}
	return t.length > 5 ? {
		kind: "too-many",
		name: "orbits",
		value: String(t.length),
		most: 5
	} : t;
}
var ln = (e) => e.map(({ theta0: e, velocity0: t }) => it(e) + (t === 0 ? "" : `;${t}`)).join(",");
function un(e, t) {
	let n = Et.indexOf(e.toUpperCase());
	return e.length === 1 && n >= 0 ? n : {
		kind: "not-one-of",
		name: t,
		value: e,
		allowed: [...Et]
	};
}
function dn(e, t) {
	let n = T(e), r = Array.from({ length: 9 }, (e, t) => String(t + 1));
	return r.includes(String(n)) ? n : {
		kind: "not-one-of",
		name: t,
		value: e,
		allowed: r
	};
}
function fn(e) {
	let t = [];
	for (let n of e === "none" ? [] : e.split(",").filter((e) => e !== "")) {
		let e = Yt(n);
		if (Zt(e)) return e;
		if (t.some((t) => qt(t) === qt(e))) return {
			kind: "twice",
			name: "periods",
			value: n
		};
		t.push(e);
	}
	return t;
}
function pn(e) {
	if (e === "T" || e === "1T") return "T";
	let t = E(e, "s");
	return Number.isNaN(t) ? {
		kind: "not-a-number",
		name: "span",
		value: e
	} : N("span", t) ? t : {
		kind: "out-of-range",
		name: "span",
		value: e
	};
}
var mn = {
	view: I("view", dt),
	th0: F("theta0", it, !0),
	w0: F("velocity0", String),
	L: F("length", (e) => `${e}m`, !0),
	g: {
		of: "gravity",
		read: nn,
		write: (e, { hide: t }) => t ? Vt(e) : String(e),
		always: !0
	},
	curves: {
		of: "curves",
		read: on,
		write: sn,
		always: !0
	},
	t: F("t", (e) => `${e}s`),
	span: {
		of: "span",
		read: pn,
		write: (e) => e === "T" ? "T" : `${e}s`
	},
	speed: F("speed", String),
	show: {
		of: "show",
		read: $t("show", [...en, ...bt]).read,
		write: tn
	},
	error: I("errorAxis", [
		"auto",
		"log",
		"linear"
	]),
	unit: I("errorUnit", ["percent", "degrees"]),
	energy: I("energy", [
		"auto",
		"total",
		"parts"
	]),
	orbits: {
		of: "orbits",
		read: cn,
		write: ln
	},
	orbit: {
		of: "orbit",
		read: un,
		write: (e) => "ABCDEF"[e] ?? "A"
	},
	periods: {
		of: "periods",
		read: fn,
		write: (e) => e === null ? "" : e.join(",") || "none"
	},
	axis: I("periodAxis", ["log", "linear"]),
	sort: I("periodOrder", ["registry", "error"]),
	entry: I("entry", ft),
	step: {
		of: "step",
		read: dn,
		write: String
	},
	from: I("from", pt),
	spring: I("spring", Ct),
	p: F("p", String),
	r: F("r", String),
	q: F("q", String),
	c: F("c", String),
	s: F("s", String),
	u0: F("u0", String),
	v0: F("springVelocity0", String),
	linear: F("linear", String),
	quadratic: F("quadratic", String),
	dry: F("dry", String),
	torque: F("torque", String),
	drive: F("drive", String),
	omega: F("driveFrequency", String),
	until: F("until", (e) => `${e}s`),
	lang: I("language", ["auto", ...mt]),
	theme: I("theme", ht),
	handout: I("handout", gt),
	seed: {
		of: "seed",
		read: rn,
		write: String
	},
	key: Qt("key"),
	paper: I("paper", _t),
	code: I("code", vt),
	embed: Qt("embed"),
	lock: $t("lock", St),
	hide: Qt("hide", "g")
}, hn = Object.keys(mn), gn = (e) => mn[e];
function _n(e) {
	let t = {}, n = [], r = [], i = /* @__PURE__ */ new Set(), a = /* @__PURE__ */ new Set(), o = !1;
	for (let s of e.replace(/^#/, "").split("&")) {
		if (s === "") continue;
		let e = s.indexOf("="), c = xn(e < 0 ? s : s.slice(0, e)), l = xn(e < 0 ? "" : s.slice(e + 1));
		if (a.has(c)) n.push({
			kind: "twice",
			name: c,
			value: l
		});
		else if (a.add(c), c === "v") l !== Xt && n.push({
			kind: "not-one-of",
			name: c,
			value: l,
			allowed: [Xt]
		});
		else if (!Object.hasOwn(mn, c)) n.push({
			kind: "unknown",
			name: c,
			value: l
		}), r.push([c, l]);
		else {
			let e = gn(c), r = e.read(l, c);
			Zt(r) ? n.push(r) : (t[e.of] = r, i.add(c), o ||= c === "g" && l.startsWith("~"));
		}
	}
	let s = t.show ?? [];
	return s.includes("velocity") && (t.quantity = "velocity"), t.show = bt.filter((e) => s.includes(e)), o && (t.hide = !0), {
		state: vn({
			...wt,
			...t
		}, n, i),
		faults: n,
		kept: r,
		given: i
	};
}
function vn(e, t, n) {
	if (e.hide && e.show.length > 0 && !e.show.some(Ft)) {
		let r = bt.filter(Ft);
		return t.push({
			kind: "not-one-of",
			name: "show",
			value: String(e.show),
			allowed: r
		}), vn({
			...e,
			show: []
		}, t, n);
	}
	let r = It(e), i = r.includes(e.view) ? e.view : r[0] ?? "lab";
	return i !== e.view && n.has("view") && t.push({
		kind: "not-one-of",
		name: "view",
		value: e.view,
		allowed: r
	}), {
		...e,
		view: i,
		span: e.hide && e.span === "T" ? wt.span : e.span
	};
}
function yn(e, t = []) {
	let n = [["v", Xt]];
	for (let t of hn) {
		let r = gn(t), i = r.write(e[r.of], e);
		(r.always || i !== r.write(wt[r.of], wt)) && n.push([t, i]);
	}
	return `#${[...n, ...t].map(([e, t]) => `${bn(e)}=${bn(t)}`).join("&")}`;
}
function bn(e) {
	return encodeURIComponent(e).replace(/%2C|%3A|%3B|%2F|%C2%B0/g, decodeURIComponent);
}
function xn(e) {
	try {
		return decodeURIComponent(e);
	} catch {
		return e;
	}
}
// src/memory.ts
function L(e) {
	let t = null;
	return (...n) => {
		let r = t;
		return r && r.args.length === n.length && n.every((e, t) => Object.is(e, r.args[t])) ? r.result : (t = {
			args: n,
			result: e(...n)
		}, t.result);
	};
}
// ../wasm/npm/dist/core.js
var Sn = [
	"small-m",
	"small-m-bounded",
	"cubic",
	"cubic-quintic"
], R = class extends RangeError {
	name = "DomainError";
	argument;
	given;
	allowed;
	constructor(e, t, n) {
		super(`${e} = ${t}: must be ${n}`), this.argument = e, this.given = t, this.allowed = n;
	}
}, Cn = new Uint8Array([
	0,
	97,
	115,
	109,
	1,
	0,
	0,
	0,
	1,
	5,
	1,
	96,
	0,
	1,
	123,
	3,
	2,
	1,
	0,
	10,
	10,
	1,
	8,
	0,
	65,
	0,
	253,
	15,
	253,
	98,
	11
]);
function wn() {
	return WebAssembly.validate(Cn);
}
var Tn = 6;
function En(e) {
	return e.replace(/\u0001([0-9a-f]{16})/g, (e, t) => Dn(new Float64Array(BigUint64Array.of(BigInt(`0x${t}`)).buffer)[0]));
}
function Dn(e) {
	let t = e < 0 ? -e : e;
	if (Number.isNaN(e)) return "NaN";
	if (t === Infinity) return e < 0 ? "-inf" : "inf";
	if (t > 0 && (t < 1e-4 || t >= 0x2386f26fc10000)) return e.toExponential().replace("+", "");
	let n = e < 0 || Object.is(e, -0) ? "-" : "";
	return Number.isInteger(t) ? `${n}${t}.0` : `${n}${t}`;
}
var On = new TextEncoder(), kn = new TextDecoder();
function An(e, t, n, r) {
	if (t instanceof Float64Array) e.set(r === t.length ? t : t.subarray(n, n + r));
	else for (let i = 0; i < r; i++) e[i] = t[n + i];
}
var jn = class {
	exports;
	rows;
	vectors;
	views = [];
	constructor(e, t) {
		this.exports = e.exports, this.rows = this.exports.rows(), this.vectors = t;
	}
	column(e) {
		if (this.views.length === 0 || this.views[0].byteLength === 0) {
			let { memory: e } = this.exports, t = this.exports.columns();
			this.views = Array.from({ length: Tn }, (n, r) => new Float64Array(e.buffer, t + 8 * this.rows * r, this.rows));
		}
		return this.views[e];
	}
	text() {
		let { memory: e } = this.exports;
		return kn.decode(new Uint8Array(e.buffer, this.exports.text(), this.exports.text_length()));
	}
	say(e) {
		let t = On.encode(e), n = this.exports.text_room(t.length);
		new Uint8Array(this.exports.memory.buffer, n, t.length).set(t);
	}
	refusal() {
		let [e = "", t = "", n = ""] = En(this.text()).split("\n");
		return new R(e, t, n);
	}
	list(e) {
		if (e < 0) throw this.refusal();
		return new Float64Array(this.exports.memory.buffer, this.exports.list(), e).slice();
	}
	through(e, t, n, r) {
		let { length: i } = e;
		for (let a = 0; a < i; a += this.rows) {
			let o = Math.min(this.rows, i - a);
			An(this.column(0), e, a, o), r && An(this.column(5), r, a, o), n(o), t.forEach((e, t) => {
				let n = this.column(t + 1);
				e.set(o === this.rows ? n : n.subarray(0, o), a);
			});
		}
	}
	once(e, t) {
		this.column(0)[0] = e, t(1);
	}
}, Mn, Nn;
function z() {
	if (!Mn) throw Error("the core is not loaded: await load() first");
	return Mn;
}
function Pn(e) {
	return Sn.includes(e) ? In(e) : z();
}
function Fn(e, t) {
	return e in z().exports ? z() : In(t);
}
function In(e) {
	throw Error(`${e} is in the second module: await loadSecond() first`);
}
function Ln(e = {}) {
	return Nn ??= Rn(e).catch((e) => {
		throw Nn = void 0, e;
	}), Nn;
}
async function Rn(e) {
	let t = e.simd === void 0 && e.scalar !== void 0 ? !1 : wn();
	Mn = await zn(t ? e.simd ?? "" : e.scalar ?? "", t);
}
async function zn(e, t) {
	return new jn(await WebAssembly.instantiate(await Bn(e), {}), t);
}
async function Bn(e) {
	if (e instanceof WebAssembly.Module) return e;
	if (e instanceof ArrayBuffer || ArrayBuffer.isView(e)) return WebAssembly.compile(e);
	if (typeof e == "string" || e instanceof URL) {
		let t = String(e);
		if (t.startsWith("data:")) return WebAssembly.compile(Vn(t));
		if (t.startsWith("file:") && "process" in globalThis) {
			let { readFile: e } = {};
			return WebAssembly.compile(await e(new URL(t)));
		}
		return Bn(fetch(e));
	}
	let t = await e;
	if (!t.ok) throw Error(`${t.url}: answered ${t.status}`);
	return WebAssembly.compile(await t.arrayBuffer());
}
function Vn(e) {
	let t = atob(e.slice(e.indexOf(",") + 1));
	return Uint8Array.from(t, (e) => e.charCodeAt(0));
}
var Hn = new FinalizationRegistry(({ number: e, drop: t }) => t(e));
function Un(e, t, n, r = z()) {
	if (t === 0) throw r.refusal();
	return Hn.register(e, {
		number: t,
		drop: n
	}, e), t;
}
function B(e, t, n, r = z()) {
	if (typeof e == "number") return r.once(e, n), r.column(1)[0];
	let i = t ?? new Float64Array(e.length);
	return r.through(e, [i], n), i;
}
function Wn(e, t, n, r = z()) {
	if (typeof e == "number") return r.once(e, n), [r.column(1)[0], r.column(2)[0]];
	let i = t ?? [new Float64Array(e.length), new Float64Array(e.length)];
	return r.through(e, i, n), i;
}
// ../wasm/npm/dist/approx/registry.js
var Gn = {
	angle: 0,
	period: 1,
	numerical: 2
};
function Kn(e, t) {
	let n, r = () => n ??= Yn(Gn[e]);
	return Object.defineProperties((e) => t(e), {
		entries: { get: r },
		names: { get: () => r().map((e) => e.pattern) }
	});
}
function qn(e, t) {
	let n = t.split(":")[0], r = e.find((e) => e.name === n);
	if (!r) throw z().refusal();
	return r;
}
function Jn(e) {
	return Array.from({ length: e.length / 2 }, (t, n) => [e[2 * n], e[2 * n + 1]]);
}
function Yn(e) {
	let t = e === Gn.period ? Fn("period_values", "approx.period") : z();
	t.exports.registry(e);
	let [n, r, i, a, o] = [
		0,
		1,
		2,
		3,
		4
	].map((e) => t.column(e));
	return t.text().split("\n").map((t, s) => {
		let [c = "", l = "", u = "", d = "", f = ""] = t.split("	"), p = e === Gn.numerical && i[s] > 0 ? `${c}:H` : c;
		return {
			pattern: p,
			name: p.split(":")[0],
			orders: a[s] > 0 ? {
				least: i[s],
				most: a[s],
				step: o[s]
			} : void 0,
			formula: l,
			source: u,
			stated: d,
			statedRange: Number.isNaN(n[s]) ? void 0 : [n[s], r[s]],
			undefinedWhere: f
		};
	});
}
// ../wasm/npm/dist/approx/angle.js
var Xn = class {
	name;
	entry;
	constructor(e) {
		if (z().say(e), z().exports.angle_named() === 0) throw z().refusal();
		this.name = e, this.entry = qn(Qn.entries, e);
	}
	of(e) {
		return new Zn(this, e);
	}
	ranges(e, t = 1) {
		let n = Fn("angle_ranges", "ranges");
		return n.say(this.name), Jn(n.list(n.exports.angle_ranges(e, t)));
	}
}, Zn = class {
	formula;
	pendulum;
	period;
	approximation;
	core;
	constructor(e, t) {
		this.core = Pn(e.entry.name);
		let { exports: n } = this.core;
		this.core.say(e.name);
		let r = t.within(this.core, (e) => n.angle_new(e));
		this.approximation = Un(this, r, n.angle_drop, this.core), this.formula = e, this.pendulum = t, this.period = n.angle_period(this.approximation);
	}
	theta(e, t) {
		let { exports: n } = this.core;
		return B(e, t, (e) => n.angle_theta(this.approximation, e), this.core);
	}
	difference(e, t) {
		let { exports: n } = this.core;
		return B(e, t, (e) => n.angle_difference(this.approximation, e), this.core);
	}
	error(e = 1) {
		if (this.core.exports.angle_largest_error(this.approximation, e) === 0) throw this.core.refusal();
		let t = this.core.column(0), [n, r, i] = [
			t[0],
			t[1],
			t[2]
		], { thetaMax: a } = this.pendulum;
		return {
			difference: n,
			relative: a === 0 ? 0 : n / a,
			t: r,
			undefinedFrom: i
		};
	}
}, Qn = Kn("angle", (e) => new Xn(e)), $n = class {
	name;
	entry;
	step;
	constructor(e) {
		let [t = "", n] = e.split(":");
		if (this.step = n === void 0 ? NaN : Number(n), n !== void 0 && (n.trim() === "" || Number.isNaN(this.step))) throw new R("step", JSON.stringify(n), "a number in s, as in rk4:0.025");
		if (z().say(t), z().exports.numerical_named(this.step) === 0) throw z().refusal();
		this.name = e, this.entry = qn(tr.entries, t);
	}
	of(e, t) {
		return new er(this, e, t);
	}
}, er = class {
	formula;
	pendulum;
	until;
	overTheTop;
	solution;
	constructor(e, t, n) {
		let { exports: r } = z();
		z().say(e.entry.name);
		let i = r.numerical_new(t.orbit, e.step, n);
		this.solution = Un(this, i, r.numerical_drop), this.formula = e, this.pendulum = t, this.until = n, this.overTheTop = r.numerical_over_the_top(i);
	}
	theta(e, t) {
		return B(e, t, (e) => z().exports.numerical_motion(this.solution, e));
	}
	motion(e, t) {
		let [n, r] = Wn(e, t && [t.theta, t.velocity], (e) => z().exports.numerical_motion(this.solution, e));
		return {
			theta: n,
			velocity: r
		};
	}
	steps() {
		let e = z().list(z().exports.numerical_steps(this.solution)), t = (t) => Float64Array.from({ length: e.length / 3 }, (n, r) => e[3 * r + t]);
		return {
			t: t(0),
			theta: t(1),
			velocity: t(2)
		};
	}
}, tr = Kn("numerical", (e) => new $n(e)), nr = [
	"thetaMax",
	"m",
	"mc"
], rr = class {
	name;
	entry;
	core;
	constructor(e) {
		if (this.core = Fn("period_values", "approx.period"), this.core.say(e), this.core.exports.period_values(0, 0) === 0) throw this.core.refusal();
		this.name = e, this.entry = qn(ir.entries, e);
	}
	ratio(e) {
		return this.values(e, 1);
	}
	error(e) {
		return this.values(e, 2);
	}
	period(e) {
		return this.core.say(this.name), e.within(this.core, (e) => this.core.exports.period_of(e));
	}
	ranges(e) {
		return this.core.say(this.name), Jn(this.core.list(this.core.exports.period_ranges(e)));
	}
	values(e, t) {
		let n = nr.flatMap((t, n) => e[t] === void 0 ? [] : [{
			at: n,
			value: e[t]
		}]), [r] = n;
		if (n.length !== 1 || !r) throw new R("swing", n.map(({ at: e }) => nr[e]).join(", ") || "none", "given as one of thetaMax, m and mc");
		let i = this.core;
		return B(r.value, void 0, (e) => {
			i.say(this.name), i.exports.period_values(r.at, e), t > 1 && i.column(1).set(i.column(t).subarray(0, e));
		}, i);
	}
}, ir = Kn("period", (e) => new rr(e)), ar = [
	"m",
	"mc",
	"k"
];
function or(e) {
	let t = ar.flatMap((t, n) => {
		let r = e[t];
		return r === void 0 ? [] : [[n, r]];
	});
	if (t.length !== 1) throw new R("parameter", t.map(([e, t]) => `${ar[e]} = ${String(t)}`).join(", ") || "none", "given as one of m, mc and k");
	return t[0];
}
function sr(e, t) {
	let [n, r] = or(t), i = Fn("jacobi", "elliptic"), a = (e) => i.exports.jacobi(n, r, e);
	if (typeof e == "number") {
		i.once(e, a);
		let [t, n, r, o] = [
			1,
			2,
			3,
			4
		].map((e) => i.column(e)[0]);
		return {
			sn: t,
			cn: n,
			dn: r,
			am: o
		};
	}
	let o = () => new Float64Array(e.length), [s, c, l, u] = [
		o(),
		o(),
		o(),
		o()
	];
	return i.through(e, [
		s,
		c,
		l,
		u
	], a), {
		sn: s,
		cn: c,
		dn: l,
		am: u
	};
}
function cr(e, t) {
	return sr(e, t);
}
function lr(e, t) {
	let [n, r] = or(e), i = Fn("complete", "elliptic");
	return B(r, void 0, (e) => {
		i.exports.complete(n, e), t > 1 && i.column(1).set(i.column(t).subarray(0, e));
	}, i);
}
function ur(e) {
	return lr(e, 1);
}
function dr(e) {
	return lr(e, 3);
}
// ../wasm/npm/dist/pendulum.js
var fr = [
	"rest",
	"libration",
	"separatrix",
	"rotation"
], pr = class {
	theta0;
	velocity0;
	length;
	gravity;
	regime;
	omega0;
	omega2;
	period;
	thetaMax;
	energyRatio;
	energyRatioC;
	energy;
	extremes;
	orbit;
	force;
	constructor(e) {
		let { theta0: t, velocity0: n = 0, omega0: r, omega2: i, length: a, gravity: o } = e, { exports: s } = z(), c = [
			r,
			i,
			a,
			o
		], l = c.reduce((e, t, n) => e | (t === void 0 ? 0 : 1 << n), 0), [u, d, f, p] = c.map((e) => e ?? 0);
		this.force = [
			u,
			d,
			f,
			p,
			l
		], this.orbit = Un(this, s.orbit_new(t, n, ...this.force), s.orbit_drop), this.theta0 = t, this.velocity0 = n, this.regime = fr[s.orbit_facts(this.orbit)];
		let m = z().column(0);
		this.omega0 = m[0], this.omega2 = m[1], this.period = m[2], this.thetaMax = m[3], this.energyRatio = m[4], this.energyRatioC = m[5], this.energy = m[6], this.extremes = {
			lowest: m[7],
			highest: m[8]
		}, this.length = a, this.gravity = a === void 0 ? void 0 : o ?? m[9];
	}
	theta(e, t) {
		let { exports: n } = z();
		return B(e, t, (e) => n.orbit_theta(this.orbit, e));
	}
	velocity(e, t) {
		let { exports: n } = z();
		return B(e, t, (e) => {
			n.orbit_motion(this.orbit, e), z().column(1).set(z().column(2).subarray(0, e));
		});
	}
	motion(e, t) {
		let { exports: n } = z(), [r, i] = Wn(e, t && [t.theta, t.velocity], (e) => n.orbit_motion(this.orbit, e));
		return {
			theta: r,
			velocity: i
		};
	}
	turns(e) {
		let { exports: t } = z(), [n, r] = Wn(e, void 0, (e) => t.orbit_turns(this.orbit, e));
		return {
			n,
			angle: r
		};
	}
	times(e, t, n) {
		return z().list(z().exports.orbit_times(this.orbit, e, t, n));
	}
	turningTimes(e, t) {
		return z().list(z().exports.orbit_turning_times(this.orbit, e, t));
	}
	nextCrossing(e, t) {
		return z().list(z().exports.orbit_next_time(this.orbit, e, t))[0] ?? NaN;
	}
	separatrixVelocity(e, t) {
		let { exports: n } = z();
		return B(e, t, (e) => n.orbit_separatrix_velocity(this.orbit, e));
	}
	energies({ theta: e, velocity: t }, n) {
		let { exports: r } = z(), i = (e) => r.orbit_energies(this.orbit, e);
		if (typeof e == "number" || typeof t == "number") {
			let [n, r] = this.energiesOf([e], [t], i);
			return {
				kinetic: n[0],
				potential: r[0]
			};
		}
		if (e.length !== t.length) throw new R("velocity", `${t.length} numbers`, `as many as theta, ${e.length}`);
		let a = n && [n.kinetic, n.potential], [o, s] = this.energiesOf(e, t, i, a);
		return {
			kinetic: o,
			potential: s
		};
	}
	within(e, t) {
		if (e === z()) return t(this.orbit);
		let n = e.exports.orbit_new(this.theta0, this.velocity0, ...this.force);
		try {
			return t(n);
		} finally {
			e.exports.orbit_drop(n);
		}
	}
	energiesOf(e, t, n, r = [new Float64Array(e.length), new Float64Array(e.length)]) {
		return z().through(e, r, n, t), r;
	}
	toString() {
		let { theta0: e, velocity0: t, length: n, gravity: r, omega2: i } = this;
		return `Pendulum { theta0: ${e}, velocity0: ${t}, ${n === void 0 ? `omega2: ${i}` : `length: ${n}, gravity: ${r}`} }`;
	}
}, mr = { next: (e) => new Float64Array(e) }, hr = class {
	#e = /* @__PURE__ */ new Float64Array();
	#t = 0;
	begin() {
		return this.#t = 0, this;
	}
	next(e) {
		return this.#t + e > this.#e.length && (this.#e = new Float64Array(2 * (this.#t + e)), this.#t = 0), this.#t += e, this.#e.subarray(this.#t - e, this.#t);
	}
}, gr = [
	"small-m",
	"small-m-bounded",
	"cubic",
	"cubic-quintic"
], _r = !1, vr = () => _r, yr = (e) => gr.includes(e), br = 1e-5;
function xr(e, t, n, r) {
	let i = r.next(e.length);
	for (let r = 0; r < i.length; r++) i[r] = e[r] + n * t[r];
	return i;
}
var Sr = /* @__PURE__ */ new Map();
function Cr(e) {
	let t = Sr.get(e);
	if (t) return t;
	let n = Qn(e);
	return Sr.set(e, n), n;
}
var wr = class {
	exact;
	curve;
	overTop = NaN;
	#e;
	#t;
	constructor(e, t, n) {
		this.exact = e, this.curve = n, this.#e = Cr(j(n)).of(t), this.#t = br / e.omega0;
	}
	theta(e) {
		return this.#e.theta(e);
	}
	velocity(e) {
		let t = this.#t;
		return (this.#e.theta(e + t) - this.#e.theta(e - t)) / (2 * t);
	}
	compared(e, t, n, r = mr) {
		let i = this.#e, a = this.#t, o = null;
		return {
			...this.#n(e, t.theta, n || !this.exact.asGiven, r),
			get velocity() {
				if (o) return o;
				let t = i.theta(e.map((e) => e + a)), n = i.theta(e.map((e) => e - a));
				return o = t.map((e, t) => (e - n[t]) / (2 * a)), o;
			}
		};
	}
	#n(e, t, n, r) {
		let i = r.next(e.length);
		if (n) {
			let n = this.#e.theta(e, i);
			return {
				theta: n,
				error: xr(n, t, -1, r)
			};
		}
		let a = this.#e.difference(e, i);
		return {
			theta: xr(a, t, 1, r),
			error: a
		};
	}
	largest(e) {
		if (!this.exact.asGiven) return null;
		let { difference: t, t: n, undefinedFrom: r } = this.#e.error(e);
		return {
			value: t,
			t: n,
			gone: r
		};
	}
}, Tr = class {
	exact;
	curve;
	#e;
	constructor(e, t, n, r) {
		this.exact = e, this.curve = n, this.#e = tr(j(n)).of(t, r);
	}
	get overTop() {
		return this.exact.regime === "libration" || this.exact.balanced ? this.#e.overTheTop : NaN;
	}
	theta(e) {
		return this.#e.theta(e);
	}
	velocity(e) {
		return this.#e.motion(e).velocity;
	}
	compared(e, t, n, r = mr) {
		let i = {
			theta: r.next(e.length),
			velocity: r.next(e.length)
		}, { theta: a, velocity: o } = this.#e.motion(e, i);
		return {
			theta: a,
			velocity: o,
			error: xr(a, t.theta, -1, r)
		};
	}
	largest() {
		return null;
	}
}, Er = 5e5;
function Dr(e) {
	return {
		theta: () => e,
		velocity: () => 0,
		motion: (t) => ({
			theta: t.map(() => e),
			velocity: t.map(() => 0)
		})
	};
}
var Or = 4 * 2 ** -52, kr = 50;
function Ar(e) {
	let { theta0: t, velocity0: n, omega0: r } = e, i = e.separatrixVelocity(t);
	if (n === 0 || !(Math.abs(Math.abs(n) - i) <= Or * i)) return null;
	let a = new pr({
		theta0: 0,
		velocity0: 2 * Math.sign(n)
	}), [o] = a.times(t, -50, kr);
	return o === void 0 ? null : {
		theta: (e) => a.theta(o + r * e),
		velocity: (e) => r * a.velocity(o + r * e),
		motion: (e) => {
			let { theta: t, velocity: n } = a.motion(e.map((e) => o + r * e));
			return {
				theta: t,
				velocity: n.map((e) => r * e)
			};
		}
	};
}
var jr = L((e, t) => {
	let n = new pr({
		theta0: 0,
		length: e,
		gravity: t
	});
	return {
		smallPeriod: n.period,
		top: n.energies({
			theta: Math.PI,
			velocity: 0
		}).potential
	};
}), Mr = class e {
	setup;
	#e;
	#t;
	asGiven;
	balanced;
	regime;
	omega0;
	period;
	smallPeriod;
	thetaMax;
	energyRatio;
	energyRatioC;
	#n;
	constructor(e) {
		this.setup = e;
		let { theta0: t, velocity0: n, length: r, gravity: i } = e;
		this.balanced = Math.abs(t) === Math.PI && n === 0;
		let a = new pr(e);
		this.#e = a;
		let o = this.balanced ? Dr(t) : Ar(a);
		this.#t = o ?? a, this.asGiven = o === null, this.regime = this.balanced ? "rest" : o ? "separatrix" : a.regime, this.omega0 = a.omega0, this.period = o ? Infinity : a.period;
		let { smallPeriod: s, top: c } = jr(r, i);
		this.smallPeriod = s, this.#n = c, this.thetaMax = o || this.regime === "rotation" || this.regime === "separatrix" ? Math.PI : a.thetaMax, this.energyRatio = o ? 1 : a.energyRatio, this.energyRatioC = o ? 0 : a.energyRatioC;
	}
	theta(e) {
		return this.#t.theta(e);
	}
	velocity(e) {
		return this.#t.velocity(e);
	}
	sample(e, t = mr) {
		return this.#t.motion(e, {
			theta: t.next(e.length),
			velocity: t.next(e.length)
		});
	}
	energy({ theta: e, velocity: t }, n = mr) {
		let { length: r } = e, i = {
			kinetic: n.next(r),
			potential: n.next(r)
		}, { kinetic: a, potential: o } = this.#e.energies({
			theta: e,
			velocity: t
		}, i), s = n.next(r);
		for (let e = 0; e < s.length; e++) s[e] = (a[e] + o[e]) / this.#n, a[e] = a[e] / this.#n, o[e] = o[e] / this.#n;
		return {
			kinetic: a,
			potential: o,
			total: s
		};
	}
	energyAt(e, t) {
		let { kinetic: n, potential: r } = this.#e.energies({
			theta: e,
			velocity: t
		});
		return {
			kinetic: n / this.#n,
			potential: r / this.#n
		};
	}
	separatrixVelocity(e) {
		return this.#e.separatrixVelocity(e);
	}
	levelVelocity(e, t) {
		let { potential: n } = this.#e.energies({
			theta: e,
			velocity: new Float64Array(e.length)
		});
		return n.map((e) => Math.sqrt(Math.max(0, 2 * (t * this.#n - e))));
	}
	get turned() {
		return this.regime === "rest" ? 0 : this.regime === "libration" ? this.#e.times(this.thetaMax, -this.period, 0).at(-1) ?? NaN : NaN;
	}
	from(t, n) {
		return new e({
			...this.setup,
			theta0: t,
			velocity0: n
		});
	}
	turns(e) {
		return this.#e.turns(e);
	}
	#r({ argument: e }, t) {
		return e === void 0 ? 6 * t * (this.omega0 + Math.abs(this.setup.velocity0)) : t / e;
	}
	solution(e, t, n = Er) {
		if (A(e.name).numerical) return this.#r(e, t) > n ? { refused: "steps" } : new Tr(this, this.#e, e, t);
		if (yr(e.name) && !vr()) return { refused: "loading" };
		try {
			return this.regime === "separatrix" && Qn(j(e)).of(new pr({
				theta0: 0,
				velocity0: 2
			})), new wr(this, this.#e, e);
		} catch (e) {
			if (!(e instanceof R)) throw e;
			return { refused: this.regime === "separatrix" ? "separatrix" : e.argument === "regime" ? "rotation" : "start" };
		}
	}
};
// src/model/index.ts
function Nr(e) {
	return e.map((e) => ({
		name: e.name,
		formula: e.formula,
		source: e.source,
		stated: e.stated,
		statedRange: e.statedRange ?? null,
		orders: e.orders ?? null
	}));
}
var Pr = ({ m: e, mc: t }) => t < e ? { mc: t } : { m: e }, Fr = class {
	complete = vr();
	angles = Nr(Qn.entries);
	periods = vr() ? Nr(ir.entries) : [];
	motion(e) {
		return new Mr(e);
	}
	statedMost(e) {
		return this.angles.find((t) => t.name === e)?.statedRange?.[1] ?? null;
	}
	#e = /* @__PURE__ */ new Map();
	undefinedAbove(e) {
		let t = j(e), n = this.#e.get(t);
		if (n !== void 0) return n;
		let r = Qn(t), [i, a] = [0, Math.PI];
		for (; a - i > 1e-6;) {
			let e = (i + a) / 2, { undefinedFrom: t } = r.of(new pr({ theta0: e })).error(1);
			Number.isNaN(t) ? i = e : a = e;
		}
		return this.#e.set(t, a), a;
	}
	periodRatio(e, t) {
		return ir(e).ratio({ thetaMax: t });
	}
	periodError(e, t) {
		return ir(e).error({ thetaMax: t });
	}
	jacobi(e, t) {
		return cr(e, Pr(t));
	}
	completeK(e) {
		return ur(Pr(e));
	}
	nome(e) {
		return dr(Pr(e));
	}
};
async function Ir(e) {
	return await Ln(e), new Fr();
}
// ../wasm/npm/dist/libration-simd.wasm?url
var Lr = "data:application/gzip;base64,H4sIAAAAAAACA7S9C5xd11kfuh77dc4+Z2bPQ9JIR7bW3lbCqCMTFcyMxrho1iA/FDuxAgZc6mDZshx7S35IHtsCTzRjx0nm0kBESZOxMDdnRiZWIW7VkhS1TepJcYPCNSCo0wia3gyXAEobmqFNL2ob4+r/fWvvs89o5CS9t/LPc/Zj7fX81vd963uKex57SAoh5P9QP7DPn5menp4W++SMnNmnZ2bwo4q/gp7gpdjnzdAl/ciZfULs82f4UTDjLtTMtJymvzP7wpmZmWn3sZxGPXgnqN5pVDM9TdWjbTWNIng0LehDfCn2ecdmpl2v0EHUiiaPTfN3qGoalUr8CbkTKB9O078ZLk+VUt1yZl9E91Sfnjk2U4wBjUxTXTw8VMeV8AzI6X3BjPvOm6E+U800H9M8dBTyZ5566qmnxD5v2tU2PUO//syxY8eOiX3q2DFq49ixGaF/Vs9pJT33z/dkEMgwCLzACwI/8v3QC7WvwyDwAzwNQs+r1Wq+DsPQC/16ENOzRtDs6fV7k8Rr9KKeuh/2Sen19te9gX4x6Pf6/ev6tReEg9F63/P8DZ4Qg71DXq9X7+sLvI2bWpu9q64Og36/N5Re4PX3h74nvS0bjef114ON/qarfT24ftD3BjxPbE49r55tHvCv8bbiH7rf19cna17NDz0dKK0iT2utAq3f8hZP6yCo+Vp7df+tg57vb/QHfc/b6HvfEw2KQSGGte9vG/wbA4Hv17T0POnpkcHBQTE46GalHtf9RmOjv33Q9/2N13p+3QuCILw2CDzp+V4dk+KH9ebG7/UxYXgZBMHbPD8Mgw3bg8Dr93b011UkhBCeiOR6729KL6x5QeB5Wn1f/1Xff9W6667+/us8Xz4qWy1fSzEYbNQz0s7OLol4RthP/8mr9LuE3/B575rgoQMPPXLkp5VI7nn4PYcO3H3fg/fff+DIgYf3HxC27h4deeRR8cMDfHPoniPvOfDY1N0Hjhx55IjYHfPTh+956MB94sdq7u7Ak+LHG3z96IEjDz5yn/gZV3DqgQNT94inwv2PHHr8oYcfE+/1Dj342JQ41vPw4w8dOPLg/nsOcXMzSefBQ49MPfjIw2JW9naecYPPyGbl0YEnxbNyfefBI08cOIIG75565FHxoerXj00dePQx8fOy/siRex+c4haPyx6+O/DwgSPvefDAY+IXZMxP7r9n/9Rj4mOywbeuP/Oyxvdo+Jdkb3FzdOruqQcfOiBOy4386LEDj95z5J6pIw8evfuJA4ce2f/g1E+Lf1LUzRPy6+Xtgw8deEx8Wg6428ePPPzgw+9xj/9pWerxIw8/Jv65jI4ceM+Dj00d+WmxJL0jjzz5mHhFelMHjk6Jfy1j/N596MDD75l6QHxe1uj2yCOPPCR+S4ZPHDjyGMZwVtbvvvu+e6buufvAw/dpGd999wMH7nn07nvveeyAVrVxKayMN31Fbvl38u+qb6ll+SX5C+rP5J/KL8p/K/+7+qb6PXlO/r78A/m78o/kBfU19R/Uf1T/RX1D1X/1X4Vz+jopZ9SEUYnM9I1NgUsj8f+eVqZubAqjjTDqW3UhYiOMTFRsdLyoZDCjJvSEFVZcKz65PJFJK41sXY9rI29sSryjN03RkHEcG2Ej/H9ry4a5PXo4U/aNN3SeAeynD6faSJs8kXr29PKSSKWeURPFf0ZmYliJTNqZm5rCyGHlGZlnvlHvaPrGN+ogqguM3EO3gVF5pm5tSiNT34hUNVRsvAn6/uamtiIN8EQZOaqEUVTBqPIwSnowrETqx2rCBEaiPdQoUaIh8ZU/rMSoEjFGzqMNemN0fsroJHTdb4g4tjSx1SlSVhrlpkitOUVGJmFZcfxuqWeMGFZRqoyw0ioj7SzWRScentOfKE89zJF9Q7yjKYxnpN112M7KI9cLaaQNnrATR1IZ48X1QmCURuejKorfygsvUYmgmjJ1EFWgiLTSyuSCjOPDUs1YkSoUHVbDBCRGGm1n8lE1jGcm0/jZert7IfNRZQwt1JDRVk+hOb6P8CcxOrd6KlM5pl2idZWnKnYrEO+X2rXIbQ5lmiaobHWIasno20Fu1aNWE27D49pT3V257qxy/BVJc2ukjfB/ByjzVLs1ZODTAD+vBD/sDX0TYMuI25sipgkERGY6N+Imnj1uh8DLMwCWXuq7oQHjGktX9o8rlkU9KjfiZrrlhfKwclxHUbWd6aqaL4oWeZzx/5DKn1HT1whrDmZqq6CRKCOTGnb4Ni0m5Y9wb0d0NK4jIyblmBYNRUO6VtyVaaswHm3lYd51d/A635l5t/KDvanvpsgrJgWrnwWj6g7aWDqp035qKhOkGpsCgHW9uIveeu7tjU1srBGdpCH1Jo0w+BE9NK6NkSYc10NGmmhcJ0ZOzs7Ozu4Y05GR3F/J28YO50ktNsqafKuI/w6BNgZSDlQOqwZBR6bQUx4t2iHAIfA0CrA6opNxHWG2J8WYpqWjC3cf71VyRh7jedVbgR6lUcn3TQrahroys3qbHhrTQ7h6Xejo9VhHkzL10F8PFWru7Hmpghl5DBCPDl6HPzsOWurycIuBhLvuHopW6lnJc09LdWNTEFaTMSrBJa9TyKsm9zSFCY08SBgw9bEG+UuT+lgWTZq5F624OQ1M9GKKpccQjJdn0nh7shDYD5XL1DMBw4EC6tVG3d6k1jy3sTCBngNOrFkLm+wtoCbALhardpR2R9I0IumxM5hg6+VJb3yblDPXCLvjYCa3YhXENpWMAbPgyhtThq+GxrDvbSM30g7lVtvTH14SSUKPkj4j7Q5M5nYpZ0qE5iUD3IEGURnXBUJ4STIQx3cRmFgxrD61PIFxfur4kkgGQeiAdKWlnfapZSpyhn8+szyRrLOML0fVEh6id2KMC1hBHxgZ/xuQSB6Xt1UQbGXKHs0z3+onsEJpyHvyxiYg72ieKhMOKy+NTGijPA1NZII8C0wEPGOXProk7MWPLolkTMTGs1GOFbEy2Wk8NLrZeMbbpqMxNWg8O5gzalGGYMrLk3GaqFSZwHjDanMWHkwjXA2ZMAeu0xNYavRkOgcFrDEhDI1nTY7tZ2Uyig+283fDqcSPwZ+t2Pb2NDp3fVnehG9SvmbCoryPoftGYcyKUIQw3jY1OEa4LDDRwVFC6bS8k26N+rEUZ3lFXl2eSAbKFTlXWZGzvCLD6pXlCdrmryxPxFcJXvJXQHZ5hV9ZngA4YuUbhEdpYrfHIwyZiYNMK1+aNB8w0vbmLz07poU9+74lAqfkLeWHkY2S7fFvBKrBSGJFFB8P5ckGrMVm3uYmBScCan0JYq5ziC0ZU9uNtNtzoxPCJqC1KvVBhPDU3y5EFthdJrAzb2/ZN+ThRBvfSkwgSCMIZUz0ZXsa8idAJhmR3euyWjJU0NTtWb0pTC2NTZTWibYOq50poZnrUiKsO9IYG1x3+DACEp35diUACvXteQEa5tv20pIA0BjfvlBc1k2cbLyxKYg1yo1nGskmIttAaES4QSZuAckYVbuNNI1RoqXeqLrBoPKLLy+JPPOH1dZRtRNPtqnNY2qH8e05kad1PAFrEI+q7Sa28jCAl2iVangxjz0ytaSFRclt3XrWSzYzbsSUH0IvaL/cZ6T9qshtPbkK/XoAfw5lnlVTecrdSDV2BzoKpF2M2sOsB0TvbP1mGqnxTJBT3fZVkXO9NBNXG2kVsUv8alRtNdLuzO38MwAhuzVPDNq9jchqMsBLqHkdfF6VgNeobuQ2dUPaxCi9pmK8lmpHAAgPmiBJb2zK4lXMz9GjYkbOixwDMkGSobq70iZRDFQ+rO7gpvZyw7el2tGFCha3ITCOsKdfXhLgx4RpjqnECFMfVQ00J0z9WiGuFw1cBkwffOaLaBpDE/Eoh4zChV0R2N/3K3lMzthX3B7fhs0NPDwpx3B52W52aABED4t6dhkddXNyc1PYjwDHXMMnl7EO9/chLUOwmFoXRwxl9B5mX5mdVkYfzHwb3sqkldY/APuHFb5WCHv9TU2iiXkaAGm5ajyrczuNw4iHeQqMdzANXQWVLwMTOsghuAkJCWbRrU2FuSOMGFmRhvGlE8LsM89GxjNhngXA6DX7z7954ff1YwdN7Qi/C6yHHZcF5ZvgyKUDwNPPPHvU/YCdBE3JQhO9gzCEb8Kb6LAQ5qlnlAkPGn0wrV3eU2VqlZ6CZjumM8CnQQwYwgaQ2BMB2AJMovucBkfL73W4U8zsqGoYnmwcRIyUWAw6xRh9c3ECSV5XN4K/8OJ/ppTHHJJm/MXHAcV8j+dYW485UNqWOA6knvHRjZtyIEr7/0qioyLV4JMkNte1QoCLAg8IYJnBF/bH8h4thaTt7NuRmzIv57MAmgBM1PYUMIFa1ITxsdKphw0ZvDRZP5aFYKuaCq+pUjRk9+aZsrVbm5rYrxSVzxDhM+GLIPOYuoYmnAvuTjNBVt0fy8s+9mz9UJ56dOCcccxlZ5/FHwxkDBp2Tjhu1d6Aw5nGagwx75qPqs1EijTW9jajC1K022ggEw3SdVwZbV8RudHDagfTJhz8wB2CKKDIhxRxWa+Im5o8X3RYzQJmIMOGjPlZcntTWEUPrLaggLOz3p5WGsao87Y0ci2FiYcHt9DTPK1RnQHgiw64M0cIlQdPpPVOvYBWnHtrpm6XcATGgQaczxNpbOrFd/zBG2/oW4svAOZ1/jC2y+WH9E7zO0XvuAYuKW3/E/ZRKitRFudrbIjQRDkmEmuU+bRt9LDanTZ4fE0aVRobbZPcCuI1NpeTj1ODm3sxStx4bJp5FoIsahODFmrTBMtAdzuMtjvzNDAxJoiWApxh8nMKrUQAbImrRooDqB5WE1lkwtzUcH1D5ucHcbEzq+VZfdStmgEm9ImBeHomt+ZWnM94TWLjgYh4B5PzDiDs/BeWhJW4xyd1BsVq8WZRnIbPA9Db1O4xjc4rMAGaIG2URr01t2d+fklwDYkhgMOf64iZbzKKoWLPoWWdnOfD/bDazmRGb1NbwTw2TJwMGA12YauI95a8HLhxz3o5n7CTCXCkEW1kb1h5hApwBhpWjeRvEf7CZYV0eTZBhd9GfAJ2A+KTk5FM0PCyKFq+AXyAB0Jk8ENIcKujHiZPPqwy5bYRSm/P+fFxbPWhnDhq4GNtZ4xuZdhA2nq3tpi/IY4+1czi+yzQ8qzEzHqgv3RSByh5xJOPqr10bFBmTN9ivVQ5xOPZs4J6ErieKD4XDqsbbu70CmWoWzd0uuXbGeO3kp9XeDKR+iA1KgcJALUh6QDxewrsE7P7dHzZbTxCO0tiTN3AEhI6eyQ5H9qjYnyodzCrYa/QdQL4iayaSutWpnHJp1Kte02M45MEgziVNqxImyZMe0yU9lKhXjCNNJoe02sa/P+elj3/sSWR/CmNYWfai5/r0h437GG1HX920NkKAsF4T8t+8jx/0ERHEv5O83d03gITR2ehPj1h+kxghdEt47eyfvBpLF1z0legVJ7TPlD1ATtM/PSA3Y7f5M/chAdrv3wH9mqQknyz36gWznD9tG+8YXULLx7W7Ss0uNvSGhBXkpt+XqAmFqiJidNYOOpfgA6bPqNa1suzAaNaaZ8ZALFvpYHpB5Lrh3ALogqfGk19k2B9E6xvbCLTvLlZtGcawMQ3kkSiZuqQK+MRQwKwfS1ZVny+xZo3sOZYyrvK8+0dxrOvgZdNfpmOlHfR7EWoMoJUjSb8TqNs4xCdqR1EbyfaJZLPYdtjZYAtFIB/+xjx9R5YGMWH5AijisC+0FzSbr2LUQFq/uL8krAq+bjkriRt6sgNBPPoPokdQx7IMtBPL82CfR5g8lUpYgvZgrCfwf11Iu5zUgkW6CbnZfzfnPQgIbJdkYUrOuoIJ6+STyQ3E2HtyMqvFSLzmDPyjUwD8JF6wrGqjGaW7MzbCdY84oxmCeX5JngbPqVTjfFyi6kEEQzA1R620dEssv4U8dbeYRPZcOqIveoJIAL5hFWHcaHoIg2Mf6MJjxCJp8/fkIdRcQChXw6kEFAvC9432YPTG5iygHmzAIfaqcyzM7c1PeM5URNq8xIJjkLHTB8j8J/AzRpcD1bx68fpTK6SfyObmulCVNIFMaYE010sSfLbtBLGIzyvbW+e/LEU8Q9XBN6E3DN3NMAC3cqHhINgCRnpC5aHi0chZJc30taLv6CY3Cwx1i8l2Uxd6Hy9FeJqD6evzSTOtMN5IXN2DCkRpkwZYlOYItH29nD62mo8+/wXcPoyzFkpls+VL0+WL41nA372q/wMT5gK4Oc6UEOcoj3adtY7AhrNN2AwPCJARLTsYG5/9ukltDIM2uyBfFe+l0zaUA5fCvt8tfAwRFPDaigZ4E4VH9lhql3Yb36oLI33S0S4Vwth/FVCmK8+0xHCPME0WVwrln2SXvMizTUItfKb440eTykhVWz/9YeXhP1vwj6L4+ZbWOz3oUYmS7F8DpiSvBj0Lnlr3Hv5dzdwFzsCYSythlS+AZL3g3Iz8CMz3No28lE1aLQdzJM/lDw+9IyVWyy3dG17Zdt2bjhRcTxAA4KIWb2LhKlb4/iQlMdWPy2xgdim5xuZnIx+HED6Yk/N86TSpOam0Z5p4O9nGsm2XrpfoftvunvbbuTJ3+hcxR0pV5JsjzdRZw3+bE224Wcv/tyRbIuvl2qmu1PgS2gLDdLOggiWpclcWS8p5JJrWShbMmo8CEJmgIxGTqc3xsc4QupD9DzKU2AE0oMwH9fgXYkdlHydoI2YtmbR/2WRbI+vFbwtBR0qZkolCp1WrZfTSde+UAqFWXB4viM4PA/BYVlguBQnv7I8kQn7xhtvvBHuaYrkb+LcCQ2eE0F+bzlEsRXPAwJp0S1XFPYjDryWpQd7FnlMTrMAsUsmR0I1BhMSYmj8kAIJhB7CRmwkHHdH9E4+pVI5GU+K1G/oGC+MUWcWWe43BN5sCgwmCWRZNDiUkf7KvvDFJZH8JzWi96IwPfoUP8pWNRcbPaIhbSMNkxgnPUgAHY4w3jhpQnww1z50Ki2Ca/u0oaO1EXbWGAnCaET8K6qicPEKWohqGRdD02s1ZhDaXiPfQUIaog2EkBrgfAl2MLlD7i6iu8Qen11ijt5owgDllwRgHlecXfn7U0+v/l5+V9//8Zt/b77jL7+HNPflFCpMoeYprCok47/FGn6NQ/gL0CkMsCCe0F+hIr2iqGa8hFxFOo0fQHnF+kdlQ4Jjhf5FDMSQ6huJyv9/P3/1OB7ISJwu422iFB8pMkBwBzEyXHD6V494r5tWEZQoZ6yLk3hkz4nkBt5UUSbs06XEk7Rw1CHJ7X+NhVIMl0EJl5qsD3h+nawJWpTADuZpRCX8l1gpA1menMpov96Kkxz4XUh2no72tMAA3dRCRUbd2srUS8eyOkmVhKm/mDlRrPEO3uoIW80xfIHdnDPfJVmXFIAx2mxqxj9Er4dyCFpCHAb5y2BYbeaTR4B9TsIszIlndPI1iYdR6oMPjEihC5zBXF35XtAxrym5rUET2CSHFAcNRSbEmgUQ/Pv4GUw1iWT4bCpJKMzTnGrS/VSlxAFrSNcTenBcb/IFKZh1e/OFnG98hwv55tWcan6H1fya1MBTq4gXw8RLRr50LPPdAvqdBVQHibeDQhoTEpESmGSsHjCzu5JO4adoynmjRCRY6wjXQbasM3YpNbLY+OCnS9uKYvP8McwfWDnJGznK7YeWl0TyvVD7NWg38oTjIERGMRGsIKCLpG1qhD3VPJRnXkHhk7exRc12o+ggPzvrjamtRtnl5VfAc9LVvyJFZXE1RFfgSAedCFeBKQpI8wi+WuIK9g9iRItkclwLEnMKR4WJnp5fnohZtMT0FYMhVeHrfQHWI5hWM/60h8GeVs4SYvV/jk3Skx7YJP1ijy+F0h6fq8AzvtB0sPeC4mOIgi3AUYx4XK/Q4tkVmcO8x14UuZXJNKjeURJf04e/ohZS2Qhid7NbuH+LqWz4MX9O7z6hMOhTCqJfNaLnVEq2EMcVyenV60LPq9djPUen2HE9K7kTRxnVCnuukXMnkoddrTjg7ONnRtgz9H5F5smKdAX4Fb5P/kKWd9ShEX06Tr7hHib3ppLYhzU6K7l9noYlQcd6Vw68I9f+IhVfkVR8RM8rSLBpbIEb247XYz2r3I15PdbUybOiMzL0/GE3fSu7YDGCR+7B8i6yI8lkWcDIT2RyMYsWYC1ERiWLmVzIaiYykSt0btd9Wb1l5AlTM97CgpGm3kI/J7J4RO8z8Yh+IHkcn16EGYQa0SvSKQTia8UpPqoxI7b7r58ZOXDzur/atZjVnstCV7/54f2Qdri7HT/cLq5+s21qn4AqvHy1v5XWSJbsnuwsC+/8zXZaY3islcBzD3g+QOJa0ICFmPulJWFqyQJNYmWlMYmL5fKP6LMyI9ObczJr4Pe8zJrtzGtn8gQ0lmWD+zFRTShzFxbAqphwYcEVqrfs0q8sCVsMZuXl5P2qaHBEz6pMMjxnbg6z8IQJTb3FLV+UWeOEaeC+kUzx5mnShzLtcdVAvRqeMI0TKEBPmuVkrLzc3v2GdnP22cnrPvAylj00PUYucstHy5KmtrC6rLeI5qk54y1mzRPch1m34kdhDkEthtBUm2b5usGvieK67bbGlHknjHelGaI93uA5SsNVcFYraq0ZD/8nj3dAv2f384+LuRu+OvbXaae5tNfNblK8PXbfjc3K+2ZnBwMxPFv0oNf1AJN9hqFiRWY1tzbdjQvBHV6SvEZnZCpBrqjsibRpkhOpJBvLNTCFuAyN4W4Od0dLlNGNxaI18FGUJ/dyK65TF2dSyRaajXF9GvWG4/qU5A3SliVZmr24a0zP433vuD6O357x7g1Uow00+QxZmqkLxafJmFqGJPmUzNM+kC6Zp/1WQJukJ6BvguLL9LNc1rsdBzECmQE6Tg3CsM0zgzgU1UyfGbD+VJ4N4GloBvC04TapxG3CP0OL7eTFYvc2TMiblbcq7QL+oNn1/HH3HDDznTyfcrNbz2kpzspLSFiYOri4uumHXLSfxLNqRJ9y5KitGETnVVpzKDxcBcrNDnpZkQwawKWP4s/REqH2OEDvJdRWQcnNgn70mh6gmuRud980ja77kMYjk7s7W7BJU1Uri8Qj+jgwWzyi5y9hNlRJk7G6e9VvGoTn5JXLFY1BqFl5Wc5m9RnI7zJh3rMl/r2npL7LIi93dbnDrEpOqTclxidSGvBplYNt7Y0BaPbil5dE8neliN/DDF6Fqy0YPDCuLIOpMHjE32rH4OkKgyeSYSMmFU7phvZwwWY5tnc2iz0IJ2bksWhazsTTOBTJp6jxFVmwl6bKXm4tBBirWUyzJovpE4v5I6SErPB5EAnxks/L3J6GLjDswrz3Fddzvzlx4LD9DZTYmNzYxfipYTUvM69j2cLY6BS2wE4CdAij1bB6vtRg+9eKjzQyUYgXfWIdo703NkUHO9Y6OKneeRqA04tezDx7DOZ9/og+G6cw91iJ8+SmtIHaRnS73kXfQ6tvb9JhgK40xEjQpshyqyTPaId+7XBu//SlJWHryc2FFQzkswryX+jcPkfmOpATvA3iX2XPkUB4J0YIizEFOz3a2DvYtqPKVo/oibSOn51kKCKcypJayXu0HwgZdwxulKmPq9OMThXQsAnGVZvQ8qh6ntDtqAIaxvIlTffbQ7Zb5W6gocUw9Hq+mQrjJ7ekNROnTTVhGp11BhDFu4eu3X3H/0g3TpjGSXzWxFrVTHP/jaTjb3LxiQ9PnExm8dbE4Ax66PG5/v22wzH2FIXF7K5FExtxBhLhghGLJkr+bWKx09FZ3akA65sJq/e00JOTv5TJypD2t8pbNHtf62SB+yb1u0oYAuBAJ3kyeb9Ok4aMq899cNRZn/HLKUj2pEGneAfi+jufDXSeDnYu1zlt6WC63gykselPB02QDph1mTTJAZxBOt/tb1bH0U7XdSoPzCBpGaVJ9rNCpM/4ptesW8z60beYd/qAiQ+QXLZ77QZMcID5gsBR4H6iwGZgXD9qlBkc1w9Azzqu9xll1o/rOxn8NGSGO25qOiAyIgdvSbZtIs9CkjqydJisn0a0OIEHAoRNFBRtXqYb3EYnKnpKpvT8tGRKd0amQ0YxtzNONNMMjeslx2ifkdwxAvQm8xtmw7huyyt30SboStYkui3vy8IWTGO5gyY2YSuNK30kyxzM5pAZMhsWdt/+tbeNfePzf4IjxkLWTN6eNujtBlNrZ7Xk7elGp/0eLqxwGmbj/W5BmmbINCtVtLNNVEEz3WA2pi1TSzcDo6JozdQqrb282M42J2+nIpeqSDfFhYUVcVs0C5vcLLTcLGwe73BdBhwXn/FpeXiz3wo/hDthLU8zvc/QxD+Q0awITAPmSLTYncY00o1mU1ozrbRhNqdN9ibogqTYxJ9NI/upJIVRUvRyWgfcKbPe1BfKE+Kiqbczaer3kC/Hevr5rIlo1DLZU2HcvVYamfVgk1vpeiJTvCSd7VOvdADIenCN5uWVmpfcvPxumwc6nG+AhgDNQkJ0R8HcyjF12+776d+f7dp914f/1X8dvusbuwzhojTo7NeG6d19yz/6zIn//KWf+aESic0AMW6sYpXbUhiGXdUZb6tzOWRFenXndtPlxE+IdEBPmFq6gXT+WLrNIHIV8ns16yw3Ang3mV7T6qAXHN+a+5tE2K6yOw4B1mCTumXthtSEuaqLBEuzhZYBmsF3YGQSOzFPhbkK/MZVbK8bLKYDsdkCrbQxW9KwSqxlbFom2Y8VHCp7treK/vldBSUONVQMk1ITZsIYUsnApndL8k4S/aD9EP0xA/cT5wO2fwg/UdrET4KtP6JJUzaiTZpAtj6ihx3iSb4N4hn67hBPXzfi6VsD8fgmMYkZqqKdTUA7t6UNQkmbgEJuSzdcjnQ23E82BU2TrEI5Lfq4mV7CZulmsyndSCavZpPZVGkHCGcj4M9sSi9VkLbWQDgtN/rNbvQbr4BwzskuhHNOlhjnvGSUsyyvjHM2mFa6CYBrNhY4B/6AJti948xuWvZF+jAwsKQREOCQObBhAiqMTFvAmF00fLOV6dX0pofeYC9hDjDiuMLcrMwAq8SmcV9TdnM80mzmp3RcnXPzcMEh4mUHHecdOTonTe2zaUqaCJoQ2CG5PRiym1cfYLGJnwgMCvBS09TuaUrCZyaF8oKxWsxYrWniKlaLgdVixmrNEqsBp92WxSa+h9FZk9FZswudmTi5zckLIBeQaVZlw2ks2euxPlcFbbMKtCOc2HitQfsZqDNyqrs362sRI2CUnaMDY1/L8QZVVgBw9ShP5wNM8E8DLIg1yDYwq8CSpFMyiw9kouWYlZgAhjmWDaZJ1/vIiTam6zvNgGkAAw0oR/+Sd5jADCwSDlBkl8+Pbwe6uCO9Chjvc2fUnqbDede4nl+V7LUy3cpLZ7aaq24nrumqUfUaOnLNqDqH361QK71lVJ2XBP8kPTkn8+RdToxPomWaOqq/kUG2vRX/F5ZsP4LnL0jGuW3JJ4PnJcQeODClRk8YY0IrjNcyfa1sC1uxke6ddUl9ZOGVvOOzWTS564OTcs5E7zem+/4ncKQLmYrRQpotRrTsDic8niv37e04NRhjRMuAFxKt5EdJM5BtgXS9RQwSPk37jGHlAd0Zs8WEuAjZDu3S6OdIpfAhmbzz0qG0/bwk2omWcNM9u/bjz8tbaYGo3OUzfFU5w0NdMzx02Qxv/t82w2abTqozHHbffzczDE3yGpM8eKVJTr6DScbUpVc1othcg0t+jL/HZXIH8y7Hpbkq3Upb8Bpz1RVKvMWVaKZxbPqwafvciEISrgmQRCi8YuzqEJSi053baBMl7yxx6uqjbZy8zQpTH9cr5Dt2CQFcoItgXC9Dy5SKNVROJJOB9Ua8hxaFPT6Tn2RF22bWyA2xfm6Q1ZqJEcWZvEFGNe6GvhzXUfyIkjP+dMUXklQ6yV0drkSxT2vkfFqh6yDDjiGoN0a0yfx2ptoZyaRImQF/P72w0G6TN2lyIFWxc5U0Kj5QyojYNYAwhTNHh9rXY8txn/WQFRcej+1slIsXcCORetmJEqDIrYPt7OKnNFmvzNizcSmovjjD7t0sBQI/m2n7VN7jS6WUJms8WK7bpQYJde2FRkpORRJonUzsyoqM+uzkG8U/8b5SyvuG+NFW/C8ljEcwpbOyMkrYB36C/cthEs9RDrTTPz3qrqF+2sfl8dkyCaMJboZG1Z24wvSTaF+DaqoK7y5b4xo2tOoECEFrXN9CFdkLHyPLdljg/oWkR8m9ZGRTmRcMflbyCsXOyCHZcyL+YfKNmixd8dl1PtM3VdzuubjGpqi4HLP6FyK8GqsxJ5+LvyplfbrCLmMdAEfEcEaZXiB+NGPd60LmE0NqPOjROieE+1pZcBIKHOJSs2iBbVSq7/2TmdeGkLSd1U5m9e6Tf2j8RVgNLC6Y2klQ60VTlEgmFk+m5byszJCjjuxeanf1V2+IH2Prp2RWmwh/ZJtsEjr2ajuS7fFOZ2nHVpXQ8JNtXfLvVMzGt8ruOASvPcaPovANj3cWFkhJR13uat0MljJKdWeL6DHSQRPoP1xuMNUxAvXgpelsQ5wliNEsgCU7VqMLC3QiEh7TCEF+k2qbisiGtcvLp2juctse4317wx4MGqO8ttzLqJDtDwUhC7aD6zZZ/pvd9jZ2x6FsTaObjs3zD0rlrCTJ6i1Zb2VhRbuGg7igDU/2H0bGf74jimbkMX9aPiVnatPymHrqUlXt76k4164nibR9vhRyD3ZQzBriZoogsUrgPd+AwLuwaCiDT1RdxzV7qZLVLrmtsiXvbbh6XajhS3zqXiMhL9+JIx+/h8vDhWbxmV4G+/uRRk420FbtSX376vySSANbg094pcOaLKejnrqWsEhQWvsaJyF1c+rbC5+nb9aR41TyE4h90ozQKG5ghCvf0ZSVmiF9xitNZ8yVjhhj/41N2t4X44owA1EC5jYBzJebeXIn+68+n5ED69ymfFTNZ/Aj3ZrbT/8cubDOZ86HdY78fD+0idw6UYUgAfffTn6SZ+D81jH1kU08NctbR9Xzm+DGNape64fD0W9BIH2un4vObRrTZ9z18U1jesldz28a02f7G15sa8lPNGGUQAaiZGHtFstnqOjBqKU9018dSegaY+9VNGb/UIyqV3HxQerA2X4jC/L8Sj/7z5Z1wD/ShMnfIRurM/3dACKH1Wv9cBagjr7aD38Fho3P9L8eE8gwDDGMFDYm2/RymNUmBZF1aCxXml12/Vf6z/k9WJ+cH4fVV5upNrVJ+a4mOzH01Oqxbng1PwjrxSB4Pe7iNQPbsNRfsZfgIbWyOt6c7S9BAt5GZCt6rvtZow1bgR5SmMULC6ZpekwdZgHkUny+3168kxyVknczvADS2vXkp1xnIG1n0X1tYnd41+D3v/UTCzckd2PG9Jn+tJeLldJ9V+Qf35DsKwGUFwbwdw8/S+6FP7Nd7qfG5rmx4wO560BZ1vS+HhN8vd4Qq/69HmvAANbq1ACOtOP6PAOfPr91TF/s50XVy1thsQJIv9h0fbEX2fyFApSsNBtJjAX5kaYzjXXTfxO2A8Ae6/BbBIgAzbfgRCLt79CDvR0gvK3Rc9nybdNn+vc2fbfOcezHMlbaoyAr6A340f1GTnrUjWZcAlYjLrsyXwdHldzXqK/xrLaqScaIZ/oLGD3TD9beTSrAKOthoGHgOdefxQQcDfgwAihIM9tziR1l0CCQONNfBYnqip7fmif3lMYSHRDtRlX3trreVPFaCxQLTc1vyiA+yiKLvSLe3kL35jZlzQ7Ca2WJlVMHkwMIglB0ar6e3M8jSd3I0jqPNKWtcKY/7bORNcl70ojLQw0Cd6suRoU2tqlVWNMfOXwJJp7ucKqHGXds04zZHHDNbSL45NBHl5j945vGGQU2xxkteiY5CGRF/HJOkV1oS6P/yQNUx3yW9poIqxWZCIoVeEkB7hNG6ed7EaxjVL3Wy/fneskg/z2Zh8MULJH7xrVwzzRsJeBzU0c9Eo6FF3s4aMM3e/h+xf3OJbx7nk34fjYBywPfnlLy5BtdEtVnN8EK0oo04ghEFHrgfC+bePvoZgx8+lpvWsObr29NKabFha1wAh7Ry1t5gc5v5UgG53o5eMIsRYR6Nkm24Xelx3i4YtjtBDRAMInamPpID/fleA9PyYfw2zOuZ3uMnKxh5/DUX8RvQLCVXL7SFaa0ZWp7W5d4q7ketyQP0tYjgxRQUn1mXM8zSZ3P8lG1vIWuz/Xmo+rLfP0sSO35LZ09sSXnERGlTRK38TBqAseerpKeCbjEmS7AtSs9hHiTg+Q3nZv6CROfwN2wutjD0R++2cPuAM9uSqMCDYDuRXb5xSWRHCL9mglHdGQayUNFq2jpBDd0AiFj4MSn8kNnOjqFu3mAXJRLJgcZfF2AKIekIqBN9a6mhkq4BgMAXWIjCbzWwRV2B9wVmGsnxIK/X+4vlhpbpmr886YY31GIsu7k4aLV5BGw6XhTNIUNe2HrmF4uNux5UAPiJzrUYLmgBoqGFbjBqLLaR7mis/1ZbUxf2OqqOtOfYZee30rg3E8xsWoONxRkq4Ito+RwF+1bk2YCRV0gRLUS0ULQ95WF2Of6jPA9GsLazmwkR4y0F9CS0Yd4YSHRubzMGiPXNHLfjVxeTlRAycowXef72VllycHsOYdsz/YTagaCw1pU6f5jXSv2QAcageMZczpVvxBbJ7rBtcoATdwx0Q2pmMbLTHO6wTyZcp3tcxut39UORqhJlkZXaG3fo5e3ZvpNX9eS/K/X/jANlD4ecB8Pdj7mQkdf6MzGoBm4wsjW+Pw7b3ud+3j96rY/9S87ba836y5ve826J9Z/ozJrU1dopN/0JU+46zoiATgmFXxIo8qkxl2TvdaA1mROV5einRVmDdpbYbZhzTLavvZe+vP2VhbZT4JB/6S6pZU82RnP46vQeR0VzkYpx20C4xNmGysWTqLbXugwfJYd7t9YaiaXd1UmjM8yqwoUzJWYTabiNaYQE7d6nhzT1xldyc01zAZTN81yMAWr1OjMCSjaiF7e0lWuXrBU+G1nPAnzWdrDB52mME0Yl/acAJUbVqcyFqHIYfXJjNkBPIor4LzerPtfOUoQ41mcdJN7x/WS4wg+4ziEMz3MCZx2HMKpHoeV53FRH9fEQvSNa1B+8FFgIaBgAusw6TMr4biQgjPw48qjlRKJzpIwhcyiHGHUBafOh9FClEAnfVtL/g6v8GU14Glx5gSfteZpEkxSs6cehYHvyVqtJiJavIvNKqsM5d+VBXEUdHCuJ4Or65bHM/2Y0QftF+QtadQIqbJTPZXK7mW/7wjDf5NKiRU5s2alcGS1F/x8G+nzzoUUEIH6zB1JjqYR+9J8u0LqOynEvPjrQrd7YL+8yd2dxt38JiblSz1j+lTx5izenC7uzuNuCRKPc5vWJC3D6kJPsZNYzAiGg0kpR6wiWfRNWQRVuwNZzSpQ0u53GaS8yZRyPBFIkCEr2vJ45j1mvIP2rHx7k0TQQwVDRjiG7RPm68Rggn0U9lS9Q+KJpRN2Lna80aRIN00KjtnTkfIvhz2+J+CAHE/KtMaQPJfgywthnvz0pEprHK+n+lCzT4Q0AkciyLRPJe7uYohZL+4u4G4umfRgNk/c0mxSSFcERCK0CeB5DCsMGF3UJ2W6iWJCISjc9eLcltJ7HIJNdLKoYIgqwJiokhE9q9M+wsgqJfS/otIBVA4DSjLeALX8MuQddkdulxTLlEf0eT9dh99zPht7nPUJMQIjCzuni6JxFRvZV5SbZz7end9S1kiHLwK8wXF9HIClMA4j7fMle1x8DYy0stlIHAMv4HdgXC9vBs+22XFSnVrXjeuzWxh5LW1h5HUGtWquHbM7twmd/Ex/AaTnfHxbLPZcwyJ8MkV5othe5HtvceQrQlwVgbjY7T7gmCa+U2T4CP5AFrdim77gZzV2JJf2+BDxjn5uV6SbKRRZicf0qUYBGDE2XaNEjtBhgQrEaS9dnI3TFl2cj9PNRLxjOhgt13OG7w5kL8U5w3fB9dt52pazSW7PFLMVcijD+jhZHG0a0zvLEIBYgNf8YptQ+NKVZoGVeSLbAQsOLzRH1XmWE+vl5pg+B+76VJDzoN1wQYmuF19GMf968SpG7F0vzuI3GFWvNJhCLTV47dr43XzpuH8cFy0IqxqOVq3ETq5VZyJ2rr7aTDxCyLkoC2GHjQiw5FHKu4X0goU9BoUVEqwJCGkVoVgJkl3uE3IDJWNuMiSH9BTSGFKYcAk+9EdG5J2IAfZUE+Za7mgoYyfkEKVjKZuH62SYzmU7c3uqSRPkU4xuBqOGioWjl1lHtXC5LXv7e1iZO47gH9NkLPaGPAwNAgWAJosXwaHXBAmpAVVGlUHxbo4fLdUbpCJyyjmKbdEoNI1DrCUeVsMUr4pityAyLHtFRtAUKxd5gIxOKVYEq42XWMuDyBguyPGvu7AAM960izTi4ueuoTDuBEE2hOuGSX+VJx8ludIwa493ZD4FCcgCUiKHCPFjfFIih1Amt9tYgSlWIgv2ZyETNp8nGMOGvtOryOZQQ0UgF99ahspwswR5krI1noE6zYD95hch/UxoBiKaC2EvfrGcgWICPirLyMH+Viy7h48oTmeDdFgIbqOm4FTw9a+Q0+yXvzKR3Gx8Co+b3Gl8CLy2I5QnwqP49AKRSHDV4CDmtpHbp+Fp7yMIlwFkDVLg0WQAgRs4CubnXBRMnz1Pn/fI89SbVjPyKVI+H2dHiEkKYIg5FpnXRacldK5+t2Mfq/cDtkry2SrJG9f7rHDxeqUdYisoco5zniSsIk9ekCyhi3JnyQbnHJiZeMlJWDb7+IlMgJ9a4Z0yAhsmuLUl/8D5Tx016nJJSVYHGiHPLefVAn+UX5GlUl5MdESyEXpWO5hFVh5use9fspj543oYw6F434sYpCluxWLmUbQI6js7GXRPDI3XY51yiCOcD6yzsGBChI1ZWGgnT7DX1wTbcc3KcThz0PhQ947SrWYH7YBiFEPFUOAaaeqkylNsmewZr30SWnxJX7EjT/KrkrlqMUb+WviClK3R56x8fFSZSYnjCFTCGt0+DqV+/Ie0bY9pNkuohDnpVm5n/uTM9ORf823448YvJFhHp4ti33hD/PhhF/u7suOJvzcyOSmz4CArFE1gArB40WMmOmi/hqAk5L6pTJh8UhoPe1nhRxQ+dGHyZFZbRDgPU1tMyeFfU7xPMmhBEA/FFjeSbexJ/zxA2vaOC5NI3h1/DBYYyg2Vt6mmtvXJLEgeYrsR+L2IE/gb4eTvc3+4JF5lIYpLKh5eVhwERbbJwdcjOMBro0+2M93OqH8cpd1bWECffe5so4ihhV5+A4uip7FpVwXdcruVIBPGDEH3KoV7TViR67/rSNftjx2BZcyVeHCyzgKd/CkCI458TwHwaxR+LUj+kqJWQOSG1usmMLVFMjZpZ7V2FsNjOYYco5gFFDP+SVgBkSEGzQZlXIDB1sHk3aVRzrVSTrNEQWTdNuxkehy1OUj6AQpqFf8qw6zDZstlLFGQkeRRDlq5M/MQpIRtZ4YzH7YnRchJCfyqEfUewR/xapitYIo6DoO4ckAQ2ln3ZgFb3iDQY/JlRUw03pPoUZLocVUJzZHW4h9gE5efXCNIsWVbLPsbLzN96Zhjxf9WKnkMMYts+8UlcliVHD2qe7kVNqW7De/o+JQenS6uVt4QdxxhOwMYM5yUmf6cVQ99LvMOJk8uwroDv2TIpxFKH0cv7sZjFAtL3IIytzzWyqT93SdvcXEHnlyEwdhqec7SLqgKn7yptbhblvEEgIF6Y/dV/Eda+WxTdrrijGdk8ouMv88JiuZvd+YM43vJwWt/5reyYJsWY0R1AmdL9CjhaI24hZpeEhEokhvMSXYcK+xyFayYjLIXCoxKprMdk2EgecX2tdWHCT+c73rIkVPIOyTc/ckf/oPff/eR77thf9ONhtpgn+D/TJ24JQvZV3Yii8DIREQc6MlO7JzI1BYW2uy6uqMoO5zVUbbeKWugv6xDq91OKYg2URDo0dSIfrSsCLyoiVAypJKXeyis7AITLNbQZfrwf68tcnik0ESLHCGJnMj9lgnhvB4vOlRr6ovjRElOEyUZZY6zapSEVacIIWTpqysRU5yNkNHxenoITAGUQ+gh+aSMf4LiiFVDYohq4DCJY7vEv7ga9SvmuGF34s9dLmpYVAQNw0X8Z1LpMhEJYv8QYwwOHZEaodtrcFBSF/XI4/B4XhmfpurVUXHQiDpWc3iBg2TlJTFIAWcl8TgAPVZJJ/9euRMFyN0QGCK4XUQuEmlZMEBBKhFxiTDmBXKeskRhRjTUKB5zoz9UsS7TFeuyD3JAliLNCCyNtDNarZDQ+GqXeWkPs35GkxcvsbHeVF4JUkPhk6jAiwg84rGduzJ6keg4ET1VED1lJBM9R6E/qpTixSiQOAUUw6aGwX1CPA9fQyE2QQHrIGv0kl9VlLCETzZDuIVFqfWmWE+4Ne3YP6Z+xY+GXUM4Ov8Sc5mcdAbzZ/BnOHncvYPdqh5BsyP6FiRUGtG3pPwoDVwZ6oROfk05UrP30kl/h7ueeD2GkaJ9lDxFYCesXDRiV3uyj9aCpKcIgFIQjVc9D1yKO0sty0qgGFLy+U74MKLnQtZOzYY87nNhhtBHl45Pp0PWRZ8JYc0NpnCIOXaEGdWE2PBwB3PWw+zuaBya9EwHettAWmABooXOM0RdNjWcwQITVopqkPrQ6GpRRGL3Ftrt5B/Jtfh3WljHGfO5oE0M8uRnPv5PX/6P//DzH/5nM2MUGWHyg2d+f/5PXvna2Rs4xMjk/B8dX/z0y2e/tYtRv4spwmh+pwspUtzxa0LIsJGclWPMTkOIB7+OO/n5vGQag+dtyUTG1RsV1OPvd+olbH+ueHZa5tVeXNaB0xJMOoegm5VM4eYkgq1TRICQpo/wAnFKGpO8sNC2Mnk3SYOZsxdrTiELE5keWpmDt6KYEFtF/LtRwKGgvGnH+7b1ZRCVaQdTgCEHrpAN+bldZkEPuUiv0N4eIyCCVjscVd8iH7Bt6rVwTH2TRqwc9XuJXVZdXJ3TFFeHgjaELmhDVJX0L4f2WN6jhEZ8qWZREXbJf3c3Tlfy33Y5Xckv3MDBHTjUAwdxmHOtzVJrVAVyv/z3Sn1dH93tPgrdR76F1BeBkm5sEqqkzcVbjVypk3dTCXJwv0IHK9q5/x0dlE7o+6bgQJ2EK9sJF2bXN/69YP+fo5357Jc+ZuESF55wRzK/iBb08mLmP5dFXdGCojWjBfmfMH7l1f4Wx2Lz14wW5LsoVccVI5w55RysWarCsYF8jg10ngCoBKPFMprTeZV3otX8V7eVozG9VMRoAsU4q/i5GevEboIh7JwqquGalxTtRmVXFJGBiEP/JBnxU0NgvwIc53HOAccGlzpwVMb/lkrefXld1M05/V3WdQKVuVR+1VmBWIX7lnokXEluclGtSht01zpJWCrSmsUui/jkp8DHUOovxPdVjjsWpG6hhD+lTEYQYtQEVFRwRRUihBqHR2tr4JP/JJWa0ce60jiIbfrixyboxGVJ+fGxCT5xIR2AV2aWqkSMRqxhnXCvpCPwgs9u0RgoMZHQxB3OIkdpvWSFkweCH0SwTr6OsmCMrMNQZxaiVm1CCulvgjHUgMiehizAXS0UrrpM8aTdDHWSo4kyVv+vKOXEI0ifFG4lRwEc8pM/wjJB9CtwogxLr+fNkDyPaLEqdMaw87gIk3su9QOHRvq7p1XhzI23sPuuLf/8ya+9Mji+CB006dgiU7udsqZwppzA6OSPlAmJc+CHqB2jKu6WBCxPwhF9Z+aZ+n76eDMIezii98HEiTP+hWCVIjcJIRmPD+OKDMoNXWlON2fCwoVjlU9R6JLlOOcQMDLxT0k9zeb87Yx8f+AEBCGCXMhCxDTzCfxZJELCM0Uv4B9E+wICEh8WEaoN6Rwb8vuOfYzfWbjRlEKckgEl+UzADCiCZ7VJLrNa9hJ0yV7+UlXqq4haqsvXdX8fh4345F+9c93fO/bA+v1Nl6tOVqNcidX+IRVXII4eIz8OZSf6rVnYQHIkXcqRPJagkLQvkyUfLdmZalyTIll3omC8dbGUea68dTF5gmPeYlZQp3vz6G3F+a36gPKLvAlnUWnlcKWVw1dqZeWtq1qhB2W0c4q/SkF2/zrM7V/37mHphv0nETKwXrenPGStzHSU0cK+Eb691RtPSiNf+sDLdKZ7I8xfQsi0+Kc6WXucxka6TIGquozkRq7ezG/H6fRZ/QydPuX8+RcIp+k9hZDHiLIHSeTrQu8D830JUT6aMg6bRYpXXByXzHyTK6VAjC6ozmSpZxMggW3MWQBlGAEuS7GF8YjrBCKCw5cw6npxipsTrrkEmg6Sm0AL8CWIo9gAA5set1RH4uoQ8XvJ5U2tHYCp4urFejS9ViymtSIhVWN830KOYtUAPRyQyaj4RVl1O/r/ENxTVIN7UtBODPnnl0Ty/Zm053DxA0ZQDE9DTptUl5dMf/sQnQSTbzTCPlKRILS1xwjh9HCBYRRrczwKD8rpl1jFSNE62VWC96Y2KvmUZB2ii9bJ5E9T8mJJChHFopMZxKim2Na6QoqLNFIc0QjtlImlPDsbcbq70yBkOS4253bWI7hCaZd+yfh2fgiZnLoK+FAr0Ld2Niqf2FnKxrXq+XySZ1H3Q2EvNvK0ZoQ920A4NgqNl7qI7BQybleOHEhN49slk6c9RtjjzTztNTpNDPkTU5A6ROIYME34xfgcSnbABlMHM0TZp1D7e6CcCeySsCu/tSSSNiU6jvAH+uIBW5vKBpHiYfbskkj+sbo8hCqcOHvqIcREvhAiCKF47YWYZ53xYVyxbDpKjPZvijF93hjfrEueHNfncNVw3MdScQNceNrwDHo8LclvK7cQteQB48PwxqTrecZNHY/MevcVv93sKqzW8X+pBocep4fJq8p93yiq3JyuNz1ro+ZKA6uq9GLT6FT6O6q4+t3y6vcUyEdXoQZrUs/E6YY3m6QN3/0Ubc5NTPNRTgNNCljFpUZRhTeqzmwmdedQPqpO8+VpJHv41GauJDlHIeDFNvWZRjpUnSgzNLZqns98h1X+PmGuwTwd7ECOjY7Y2k0cE+U4ZkOM6LkY4Wjw8RrHPDGiT8VQCBE0bDQbwHagPyP6jIEOyUEHDITQCYqeN65PbeYMe2Kbbp+dGNOn0ClMyvGzE1Q0Nv3YEv20JdJNZgDCwgE3MNMZGF/Ob8bAjJv5P1BmkOSHnj3F24SoX5KuM33poAnTll69bTZxokB2gd4MRx4tA6VjkxBiSUwf/fZd6tAE4jCGvKcojmS2IfktxfbxtINJ1LkkbPuUiwFoNtsaYsWJYbXUyK66sekwjmkU339DsrXEkhlVS7RWmL7s6hPmap7PirXp/mxza1zT4m48YTYa3J0u1vTeSkGEVNpo24G56uHkyexqipKzscNvX30S8UsA+a0qx35vU3J0zA2xWWeE2cAouwz8sg7Iep0ZxM+gaeGnxT7+DJRezmmaKRsE58M7jon4fzAR4DtJvZ/833x7ehgE6KpOSofubA0gafEWUSYHXpXLgdIArxVi8Vtf+e5CLJ4TFGJx5E1DLP4aRZqfdsc/JumuIfIPXoOei9X0nBryVwfr3lEN1j1MNP7zdLKqhO3uFBgqHw+WMbyT8qpRRvOOXOCd65w4wUePrisDet+Q0s9Oknkt0fGK4ns/zaob0gpAdUMGDDibf4dRv/ns+Js+WcUErPRy5+UOy+UxK1FCHcdgIesXjtYDcTg5Hw2xGKdMsVGkkPGJNwidFS2S3tFwQ6v20JlPPoHo0nlWR/5mU7fL4lBOerX9CIATmtpBjk1Br6PKazAEoRU3H3QB+m9vVqIlxNzJnQfgqwv7KXyX1Ub0nWnD1DgfB0UYiHJTKwNwG2/BNE6WGqmVXVUhPcLFV/QpTRoEgthC5RwbtZgxo4TUoxHHjlpspx6CzZqIrU0X20ioBjl7yGtkfMQ+hPrMv5UiO3NUiubJzPuWJklrtAfP/dubyjRpIFCFRGQFAuVieAYRBgLOnVhjOzFEeA33tKgkDvlZbCL8NBbKmIyL2Dht2PWHVFXPQtZretvGMz2I7GPiBQQharfbpRtINLG42F5sm+bJNKaIsmi9Fx/gMQba8OKu+a9gKtIA3MKG7ROpx2TdW8RC3NKm+pp0M4FqFCe5euWLDitXKo05ZEnEOVE6ApA/ktKfqRp1QdawgZMCK04KrDmN8Q2dzNHXGYkt15U5miVZ1+XGQ+Zo3+7CxJaZox1m7c4cfZ2TUVG24YxM/W5AQoR7XjIieZ+kvA+UuXcYmXtx4HPpESpe0Nj1Tf7p4STxhYGYF38p0iGE44V4p2T2QVgkm1ENc4gOxJhzstRhNYx09LTlEHOYw7Hi+XWIiIkZIWZ1u4uSXslYHWSxPUOKwJhyNwdI8fn7Lk11bL9aXCKqL2esJmoRmXqyCVUmaY2JJGWs3o3giKMk3q1j+n34BexEECt7BjVlMcl0rsMTkukgOzUyVkOEFSOeQB0Sn7rLWF0rM1aXo24Rh279MmM1+DnKWO0j2ixlrPYpY7WfXIV+PYA/hzJJGau5G5TGN+a0i0E5ag8nBwS1yJT1KTmv7xLAHjI+matSvTQTV7N1HJvFUcZqcDnXuYzVHWu42/AHGauxRKniNYh5RQJenxC5u3emDYwyKjNWqyJjtY/UfF0Zq1XMz8mA1s3IeUonWqOM1T4yVjdQ+Z2onDNWoxvc8G2pkw6pasbqfjYGWXmtyFjdYPFjyNaCLo1GPFpmiSYpzItFEAnI6gRAsLN9m060KnntvOQn2ZRwb8kl3sZTNvdzNGWvUj5TQbPB2bJ9DhmBmBzW4/49Q7aPQ6zu6NROzy10495nM91thaLXEnp1W6RcKjPzY4eP2A98sQiCzFuqOkPEMO8kOYZbRBLu7XCRlSoTo2N6gSi6NH+U/5sNFwKezZhmswxwxMs5nNvPvoxRkA3mWhP1jdnveqIofjJLjTc2gxmFGCEz/rQmy1jW6KoZihZyPCjys6lxEpu3PSBVPaxe8DjU0SkPymbstVO6kwa5DQFVW+fGJ8zK+Tlpg/HjAKg1tLtMWEGtnG5xVQrgtiYttqFMlC/ozKdGIYqU97xkJLArlFsDVBaCygHOEeximmjENImuENEkwOsEdhXE9vlg+wKOaBKUYiM21BrTdxZmWq/H+hZ+auB9yvp+LMg+RE9+MfM78KFhqsG2XsivO8VVqO2vx2qaWbEbRhG7S4OTfYCCjYDJI+09jIJosuzHAYAQUKvPdnylybSqvtfUuuD6iKlfAZhrDMy/BoenDQTMNLlZWO0txndas4yPYjWd0rBn1Tz3ozSAkEZUdjjgQCVpbALyeWngdx6+L26lk/dLrintwW9bp71IZfmRRpogAdLun/uLT7f/6vOnfyilJBHP7f7WP/jLP3jHvXt3LZZv2lnfyazf9C8iWkbyAZkNmMba5Qa5XLtjBvVxl8m172S2zqxbxCmOr6plsnW7//KBP5n79MWv/hAUif1dd+t2PzX4D2/+4595dtei6Ud4JQrIABT7jM7kYpu6ZAYWUPGgGUQTAwbPGwtotc/0dbVl5Mm0z0Fi/+71P/7n/+c/0n9wA/HRfZ3bpozLZsmrcFafTD4oU45rsMbYESuxH9z1et6Mrym3GaHpeRVM6RkvTzcYDfUkTntDpdD7b08smv7kGU0jSjfaqBqYdp1pcHf1hFln1uHAuc6o+/FDgYjWASQrtpxFaq1VYHojOwZxNPiaqWNjAXJd6pZJOU1ZdV/G9DaeQ/TP5ziOrtkIv5qF0g95MbuaAtOSz8jV99/YVLawlwnsCmWTICRlgjzzKQwDy+4GcEVJtgIXunKdkW0s4RazbiGV9s40MBsQMAs1seXNeT83gZ192fE6gX22uGQ8OEeAveyn/RS0le7O+w4iuOWjOcFK/2Kb7xPKFIv5D5yRzXk/pyZssLrWQXYnL2rN+l29c7DxRa2Di+1scFzP+m6r0fd2hc8xGr5N87C06B/Xxz338sy/oJD/VB4ttczgcxzCGFvUS43ZbPrpScqhqkZ021s06Vq77WSWmhT6K7NoNq5dYKPZWAX+zHw86wg19leimq/sMhsB4Lt/51X8+/quxd0nnsO/LyBM/GIqLWIiyjKO9NYJigxqqlqTK1dVOrE/oxG6WBdpSub9DsU6Ds+c7BLtOO7nDqAy6wGeAvCA12DOfJdCWlg9laeebR8j2nTez7sAxwT23GfB1oZO9HgaKxY60WMboQG925uU2NfFVAWIEmCYDmCgNQaPnbygBI/0vLqCDO0ZDnqEvs/7JHLNQEszc42rzpHu4pA70JUtoE9NmPV26aP/mIPamgFzFRwPGChmvbQPv3Mezfh6kIJXFeUbtK+qPPk/JJ6cU4hvLs3GRQQcN+v5qB2YoaLFABZ7d5oAPnJ7TQDXuFtMAA4I9HM9+Ov1hLW2QF6VNkx/2nT+Sxck8uuixxPn+n/UJj8ruQ/cbnKtI6rfkhkiSZyV7v7rMnsLBKwFdTXavMVFKqT4Q5RZjCjzq2pMfV0ylXtNjcI+SKODx6ElaZK9g0a/ZwmNyrzsk93uthom/gwMseYVV3NWjqpTylUvx/RpZ3mnXkOpM4rSNpODrUewwqLH74LVANYztRcL4u2xgR7nglBGnvylapqFrN/lTvhRe1+TQyia/m/pDAwXRanZzERj2S9MG9R53wFc0zSSgwTcelgt+/BwupWxo8odJYyN39cB0BF9XmVNwmEqayQHGZz561H1Sc2Tct4fUy9onuezmud5Cb9yXJ+mX7CG+ZnFcX1GOyBnbqh72lXbq0z7aa8z7Z/yKtP+GY+nXXAc02BUHXVzjJRKBTN2SjE3BmZ3Hr8xZTuiOTmtKCOSW2vYnJzCXa/paVeNrgFeCTlRyZteIqgrxI66kDBmGSSLKYsZ05BSUEK0mV5TkDJK1Rqw4i5DMTKL9ZIfdJ9AOEKVON9Aj7Z7RscxLsF6vdAEHd/AgE7UlCU8JxuomC8D46dZp8bMT0ZgUQojQnuON+815pqqc2C5EKafNiPN8Kc0bb/Tnrt/QdP2a3tX2n6oZkXkWZA0TUAijwDyvagjntT2eAD5RxB/waM8keF0V2DIbi98igaHPIRKSOGRJWKHL4HdTXl/dEwLCjQIdUhKbnxzccU2CUyO13VH+tBzceY5uRNyYrA+DNEW6uVzPIZmoetj5Gj+umLjUWfFCwd5+jtbg70p2YbY43HuCpB7eZtNtHCV/IVyOYdPxV1OcFVr7m77Ycy6C3c7W0t9bpFSBrrOOAs+7hAZvY6QbRKMYBZT9y5YxKIoN0NkYHg8ziI6cU0VbjcoiSQ3a8TO8ZKHusYdnDA+pYkjq/BO81NqwtSR0MDrPGxn/n46YrvJ9Qv7D1yVsy3dIszF5QyuEX3kL1Rhyx9fV7GiYXdKkfw9Hn3Kk5/q0u7fiLaRJxbjtvbJOOFYxy1LbhXdHqMCMoYOxL1vrylvj77rSLfAIfO6HJ6Md0UJhPjRw0cqdibIdFqNc88H2tLGhzMk7P7Je7/0paE/n3pwPzlL2W9q+6HpzndIp+MnB5IPQkry1EOfg28qyW0m/dnJP3v1uV//s1ef+8Xvn345VdZzfI3PIpUZMCkAHsr5tAjv88WTBW8+uHSy7SzVyOYRFkOSPcEC9tUMKQTk491PjUJAGyO6IgUJCmkTMaiUbhdtU7jsDU4sorG4Y79xFLZcyiJUf7in1SWyr2yR0sSvMGrw2XiJ+7PYTuH/pV12h4Ak9xAmdJk9dEPkt8mEu/ydZkZ+Z1eSaDigfFWxlzN0RK+R3CZi19r3z7ok0ZD3WJ8lO+dZslNA+Tsr+b9ZfkNZvTVn6tYuxTaPlRNlUxBdlzY7sWdmKeZykhuFYLgXdcDGOWyg3SVlZ/K2ykDHW8tAZ20Fm0dGkkyjfOdyTV4ZmGRJMwrlmQclU8B5fBMiZzPwray2i+S+iDxeyLANHQcl6/klHJhF8nMUKGAIDSKeGLmnczKDarmgWu5dTfY03JkSAjQQmrt+8ifkD7MDZ8kweVqy++NQVjO1eymNFkB34bkSK0GRi4M6hGEhes0O+lFaoyQNn05uQiB8UzOqkioCTlYKOuIQ+SVU2XKlvTry4whTQ1TFNACmdJdukCZMa6Z+WW+akhXCq8yinGt6/EX2YlTTsjCl5VTkJHfXyfexr/GwGm6KScWm1R5lQsNjeI6FJryX3xmK10+hsVfNRlmfncmT74OlJU4HnvG26R1sMeuVYlZ6esuYNlSltw0htJ19F5UausQODrlrNgSNUrZcYUU3K4v+gy7Uw7PqMlU0qQ++YyszVkdXQjBshoiASYJNcN0sbKhijphyiDN5P8DaqPuA/UbVPvaJ3lm6RpNPBrBDEhUMzqwsY9jPkREffCe4jAubvCwpSISdMaKVQfYtrHdry0Y2SnbSFuSIvx5cXctwlNMcEOUod2Sq0nQRQydKsbEUKca4SXiORMR0SRendURfkBRwnOZu6mbaH98sC2Ps3xSkIfsmddKzM8ZrJR+mfhdZn3PXLadxQd/Ip73YooJ6Wwq2plytSe8aln2zikH4rWzFKQkru0jmB99RhN2mubkg47UsE57/LpM/cizs5Hve1DLhTwM/gts0ObrAzUVVTA6f/y5NDqnF0kSB0yKSLnLW0J89LaunUkm2iLDsHMrJn2OFL0POoYLLiCgHprpWZoyRjEDZWDFnLg83v803MddpvOQuE5u4g6wWOWMVDPVPOYhVOBJzsrgllyzujEtkepoSmUI50h1emxQp1Zi1TclMXBnufnnXomPdkix5bvcO/+e/+r1vjIzcxyliEk6DCm/UdtYHn29E0TV102d6YbydkNMD5SpNcq4kdn4QKMx+MFyobZpWTll5JDlAPq1VFXf9TcPrk3MkxWtU23Ti5sLUyKeAEjLVnFToFNl37Ej73RDJ19jlfYMZTvfsrJ6awyQHmE4+gjyrkTOGD01U4kDyNXmg4mtyp8sTjswjKYwKGCiKLCfcMFY3YK+x47JIuPNR6TzB6i6/T4/L99PbhutvYnpNTDMdm4TiBbZNv2kiojX+vL2VrzWVQpBin0xlcs5IIshGJoeAQFSQwLe3aWlj38fv83W5xUwll8CVrd0FOytVDorfwsFRsNBaskvSgd/5HVvYvyT3OxeUwgDdmde/7+wXHtpx92u7FjP9XHlcYx8lb00fJf0JsF9VHyUK0qfX9FGCktPogoAuUapjjiujOK4M3rqTz2fwlpyDEffDhxuDv5AFC6TDDsiFYfdnPvwXv/HExreNL/Kpq10cQCWOgh58IfwFihLhky8EriT9LCxwIo9q3u6w5ayFyBk7bGW+6+jXODsxZJ7JLyruMR8yWaGt1nCb808Yj48AnZMifzvE3yYdBpCy1ru2dUXiLJ/LdNcK6DVXQH4C7MdlKyCvtAIUOQcpyqXR97Qy6fwIAiPZgcBF2/l4PZYu0a+e0cfIwXFaPkUc9DnG+2v4t1cmtFWk/eVJfS6TJed0oPATQKJgYXd8K4YvR+ZPXjf3ov2dJ/MssMETsC4qAP7jvyl+vJWFto+ddPSUvfBLSyIndrZQIJY7Ino2rU2KtD5ZnJq8IjMezDxAcKDAEclfK3Yw9XLCcAgsM80uT3DnMvVpWHDc8dJ0ipDrR9EY2xqibqeI8eHkGtpgygQHs4adRcwUNGtf1lzOcfOwvEHX65PyA8af3DX3LKxYcMM9SGbVS8+CJwSvxdbl5FzKM0RC9MkZ03jpA5Mz709rpmF3HX6J7BGQlDyySxXjdcj9J0Uau3S9E7kJiOia4B1NScM3tfelZI8WE6GHbReNDRNatM1IdFm6xsm4Av1p2DdUnqG/gMeUZbZ2XmEZd2IZsXIINGSX9O2cFQv+l1A6TErT/ABml0Y+nfl7X5qG7KXIEKpci8nTyugTaQ/JmNeIRtRLTt8IEFLCE3Z6UopMEPhVnjBJiWfaWd+C6TPJQvlBu531d2yLe0yygCKJ6TM9QBQ97SwpkMs/AwXuN4npWcgGFkyPGTDJQrtdvqaKsx583WP6LpGM9u73bvAuzP/eKz/QTk5BQNZLWg3y+x/i1E8J5XcG4OR2vV15nlOsmMiGtv1LTqLORigO8dSTp3UmkzeU8ScBCYqhuIyZ8Vv3Z1HLyN28Fb5yM7LMci68RiuL32vql77q0A5y6ix2y+zsjIlaJmyZRuu9DPHvTT7AWYjd0s7+MoVIWeBseIrS7JF/cdYHotm3sEBpIyk/PB5JPGqnifseqRGNhjiNfJKlSySfMGkuAMcjwCGYfVlzIrbjsgM63ksf4KhKDCcdmv60Kl3CAUhB8gyOxkPOUdye+uUlwWwAl8HnrsyO1WUEwuIlpswuljgpHdZl/pcLTYey54hKnytiCKgi35TnTPeKeK1gyHyOtBaAvoBiRORTRPHrDD+plcFcOnIksvlsZVU/UxKAho+5EFn+7rf86PK///U/fuT7iTSXXsIkyD+K0AHdkv1OFickbwySWY0AYx564ZHP/X+hQFCrKrpldUVYHcRePDEBxOeRJf3FExPk3r9WEzvj8tA7VDkKR/x0LzxG+Sl4umEmFHwcpuNz4g7Dxu0gj1xXiyMy1JPGJVaiKak6gyLgGc4e7Pqn395Kdbx65igPmH3tvbdwYCavdFH1ShdVemo6bQ5X2ryCOx+J1yAPeCw5wPxfMWMISdSZMePyNO0A1qY4Ap9D7KzGdCVFW3c0KnJkJLaDPAHTkCRfJGqP3DuKJcXHHc2Sy9j47LgZmNDUObJUNYdLfSHrxdGiyUeLELG+F7J6J2Z229Q4BhUoxqJxId0MAXay2G63Cc05t8PSR/Xvy3he+d6MfEpNK44jZS47nn530orudE10JjUCJjrssudzhPlMJTdhryR/G56BHPszKmJ/1lzszzpSAE6+//O//dovtv/8F5bEmD71x0gBCAX0PF0hqDNd1KDxoStABKcMDFelDFzN18Mr7SONNc71ho/1S0oFLMLZURygh6oH6M1rHaCH1pwPr8tnD2IPdtub/TC57Ql7/MPktofUjmyIj5miAzsOLHAsowKEeMmzz+X2o3CgnC80TJ6TlL2NtEkGvmO4g8MMJanEeZsF0+BlKofu5AQhe4gdA8OxYIbJZgA3EQtxZjjG5nd+RqKYi2fWRZpkez7JI5zz5blfkOQ/3ol3zWGIOe6F5IDPYV7EKebQvz2eEIpi7yCU7rLPbJsLIvwj7KIUcezeuVra+J/svQ2UXNdVLnjPufdW3apbP7e7q9UllX72PZJJK7ITzZqMWm1M1FfIsZ2ExAmZhWFBbMcx8SolPMuRhRmbdCdxeAICaQcHZOFAVSlxBCTQ/A0KOLgHMqC3CCAeJIhHHJq8LJ7WEHjthAE/cMejb+9zf6q7WnackMXM4J+uqnvPPff87rPPPnt/nwAK12HNPKDPPoRdaz1pv+pjM+4p/lHLiHsvHBoMZt0eriaXoi6D0ZeTUw+pbvSLiC2/xHHkl6Jussx4sYdVXIVMqIqkoK6ksXfB6o3ihYxObKofiQOok69nL6I6pzcNjNJO3MQshnWOy3gblSUaytRm3VtYTawnC4x2IGWo20iaOjpBOI+lwPL6hYhfLyVdGHF5/8ZLEjY/fO3CiGsrI67hYDXacHVBdc3Y8FUJpLNY/PEE4AH0jP6HRfSCPqBX+Ys6oL+4qOwSe/Bbs01RgV75jk4MlLjVcjeeTHcyCU3Q+OBMvMX2GJpmiiMmnllkGtIvLqpu9EsabsILDynDwaflaf3MoorbjBWQtuG0fvAhZRrREqedxp+rSVMj+eiTHDJGUzRprR5TNJlZPbgHz/OImpi1Q6s16y7zl/FZ9xx/4Xcc0J/iMXbyIS4ZD7Bf0YiMOPmQimv4svgQLFecJ49Hah7QjxZz4BfIo7+q07gXeeBDnM4Z9YCAIdg85elf4/O4F/Dgr1sn7hpt4YU5N6+8Gctzg42BiRNXaIxjV9T1wj1upzKvkLUhFaD2COFU0bNvgAt49DFNlWRB8zZyH+amtM8ptA+Ucty8if30F3TyqSdTnY9/Pp79FGj0FCq9xm6VszyDFu4WE1DIIjbG2xTieWVukcI+Uo7i2klw3NSp0WXzLHsZlzHn66zwl5LP4m19LQASCh8UI0Cm3cUuJfkibv/vOGvhe2382Z48I2Mq5CAdzgpRH+/9XJZVC5ILAgwCKOhi05I8+jnJChE6ZQQBl6d1Lfno5zgrlsmf+sCykzzlJA/+5LIjBJP/NsTob3wdxah6vmL0/7dC9OsgI3VRRl5wNhGSN+PPG16YkEy3tY8imPrfvLQ890Kl5cf/XVqWGVB2hLh8tYjLG1lcYhKNkJcc33OkKC8PjpSX14m8PMjycv9Iebkff152ZXlZhmoK3T8IuxkiOu/wxGzvysGphKrINpi9JRPxeExkf5UoUcSFIvpjEqnPtNRir3DZ84AxYNiE+08vb3rzHg7AWUnG/yWOlmEMDnGGWJjKEJdm3XMNOAQwz00Zdqqz+NSzbq9B5czxeNJOMjgeT15eaBYnu8wSUGGpWOGQUpWylcJzopqwPadE1ROIfmPrJM74q4mX/Nr70lFSTnqNLlVh7uGzgMOKjZRwYAYA1GLUpQqibEM2IWLt4uPWCnxcKiJv97nnI0Au7XWXI4zUve4iLzH73FNAdCnvdXtR3MDvs9gElfe6SxFP9PI+91wE9J8LEUDFZ9zzkJ2gV8Dnyb+Cf8pyZNsIn40Zd8km+Sg+hcb2bCTN18NnfQZMJZzkYXwK5+diJNMZc/u94/x9Ed9PjmOs1iGRTo53o0fVkIPg5QG7XM+DXbByI1owqUXbecXGSMdGrYSP83XmWQDE1HId5NRlHJRfqsGl8oD+Qk2WsxV8lvfqk+Mzujee1OIKaHlYei9Oohg9LgYyXJxMX62ZtKE8rVdqN3A5VmoYlB/kZF+oweGuJL10WSU5NYlyVPGSxUkuBzMEmoALU0lqWb/haHx53A6rZSEaZbFY3qtXakyRVEaOl2qmwikriXpVfZgul8KPWNyz+kd4lFGDP11pYe7EpCSBSOFwPF34POLpQglB+tRHwLIdXc/NEplKzj5cZif5HmxS52oypE5Fs+Ak4aI/HB3QH7VNf7ZWC2CwqoleVE7O1hDG+11UBoL1J2tUTn5chhy+ThzQj+PzA3wJeadhdr9WAzxEnZWX0GbjRT+j4N3ZyK6i8hieCbwm/U2PEJMPI7qqhOgqGXDF6jkbq5dXiWcXe8+Ui6yLKPwQC2MtTKsvE2mJA0S52LnD988wUISUGo2AcIEj/pn3X6s+uHuOah9hVoHnWY/nUYsrdhLb6PXsiJqkFbDxq5W8T87WpPzoi8vLx+MYq59GiXT0s1i8K7aD//bTWQfvtR18dkQHh8jkbA0BRmXmDeulknVDrc7VGMlPfpytsStRGb4cUTqX3OXajHuxZpMsIcn5mm3rP+dWg/vf19yy03nDUt6u26VZh8rEQt2Bu0Aq+1CUdpeVjSjq54eJcXPYYRVKWjQM/keOrFMjbbJYyFK51ujK64AniRdNYjxxiSeNBzQ9D5QCcmmRLzEaXC9uohmbsy6LUj3rsgh1Zt3VmpWEbcA5SSXOO1bn7jW6yaPM1Aaz6PNt3F5jY+My5Zht3LONrHE/1NikcaWiSzXm3CwuJb3G9UWM7YiXl0Y8xstgIx7H51IDewG8yKL2rCMNiM4oGkvm3941leQLziuh2PMLA16Fa4WTiztw5UKt4Pv9pmNmkiri8IE1uDHjnhpPRxCzrI3bomzB53IjnuJcGzHvci804q3YkzDnCTSQkT0ONQWaP6syE1aVackQSQdbOh7AZYIX1alCW4+aILoTWsQ+93yd8H0b10C+R+RmxzUINesAF4QdWFgKfDVNUPR7eYHNkHdiIeyxU3BM2c77mvF4h56jTsEdyaEdQ674VMZh1xJev23WPYvPzqzb4wJcrMVM/Ls4Hu/kaTIe76IytWdBTlsGVhXWbtoCjupExZSDj8T5V5OXaTdtrbvZ+1cOAS8oOfnkskOV6DG2I/vCUuMJZw1IFXBaHn1IxYY8fOwhMN7AHxAffu5+UCVgsRzl8Zmo413ACd8J1Y97xtAeHIXIsOYe7jXiq+xNX85J5Kafzh8k4aiJgXHy2559dnv2rDP0LN/EvL1q1j1vdellfG63OrZjB6ZnB6aPgSmOtQKCn5SEN63CKvX0K7IJVgE4C8PNVPlMSKBRvJ5xhOobQft+37gQYQ65/X5PtOQg17Z43O/jgu3jYu3jQu3jIu3jAqEC9mAnb7qfU5tMHStqoLj+pMruSkqkGSFoHQhaZ0jQOj0T41Ivtuiuy/V18K54TXyaYooLbjuVDm0/Tdup0olOJCpxE02VTiHFmzsxQSPaRTtpF966k9+6A15FhnbgfbsTnbjFGWEfkaB+aTUIVijvtq7nU7EqArUY5uCPQNbMpeebTKUTZxT2z+ZDt9KJrxpyKutYuVyxUsC3ctlLB/A6uczg0ziF7Zkmr2FNxHhh9cIoKMwSfo/tJkygvJiufRwP+ZTmIhkYP7o1HzxYGG1Xsvd9dK9clWs9WSAqWCCYQcx0TsdX2XeOiLXRxJkXMsDB29HoztgvNMiOzK1lqNKJE+extPHEYYejL7O3kHrkDO8m67nr40TixgCItmMUa7fl/yszWfvEJovK4oTI6vPZpmTNcS8wvB5Tghf9SHcd1nEjb/M9+dct+VePQODk5ss1KCBl7yWTZqkhwrcgdNwRiX8+nYXoDOfywObphQC8fp8MjqPRg47kYIzkaPbIG8xVPQgQl64ij/b0+4xxb/CAJ916tiELSa8Rx6nEO42ZOzwNndMAsu5EJ+wz9nWxycuGe1ae2LuSNro3n7pDTg8U2sx2p5mlbbXDzmdUaxel09rhGf0cjmkydE/WDZd4sjOI3mZz35kvDoXdOIQar4cNu0427Do5pFWK7MvUS7nFPYMj/1r8TcU1xeywfbDL9sEerspVBACeXVyVq7gq5kVoM6JrnQUMuLED+pkxKtPWA/ppfI7DBovOnuBnWpi+u6iFB/fMuqtIsmvWvYTP3bPuCj7NrHtxTNaiC/iMZ93z+HzRrLs8JmvWOXzCpWdbz+ygbf0+7aAO7cB7Osh626zbG5Nl6xQ+29SmqZ7p0FS/Tx3aQh34BW1B0i2z7uKYNNvJMVkJF/C5c9Z92ppLVvFZcH6Z7Jgds+4lXP2mtdC9GInazbYZPcu2Gdt4QCQck1+9hoGWNyYzGJJ6n7vKmgteeXFcXnnBaiqXxqVIK1bTOTkhWuLChPTs0+NSu9VxmfArkUgFmfCRFQXc97toD41F38PrwKSpgPO7soHzG0chdtsyadxhjqnwsPN6Cgubgdcfo/DwO/O9wTHZAux1e5MzMvZQisVJhKg2ZHNXPaDlBoSn1SlcDNiQxmhr10yjWNMbixUMrdN3idIrqtFyPdt0YXWiKsTxFrZYrYx3D+iHxXq1iu+L8n1hIrdqXRhnq9a6SFcSxEtHw7+NouG1q7Dae+GQVvELqW61zc7TKXt7F+3q0R7a06MAxHaSqG0TjWO9yFz+4onCEn3Yi+u14tqyLXvfYsS8GsWJ/Yuc87lJc3lK9OK9PGPtjxdbn6KNikpeckjoorCjF9NeWe7OjtsajcdT+dq/coh2PgZYTMkIy3j+RK64Nu39CepY9Wofp5g0V2diO2uKrL32IL3c71md4mwjThWbcWrT1hEtmb/qyD29X7x96UvnXDJksh+Q//kE3o1V4NYhFVoqXsi6lUvcVP2GeEGjmogM7UYZN2Swj7hu+R5pyYrkIS06tUSTHM9lA5xNk/us+RifMmiSlS24xZku19nta9iqfGESDXSNc3FLPGlzejG9uEd7aW8PTSpdkxYSussY6y6FDpKab6gP6vlLavhpFd0Zp6JmFeDDC5P21wp+rbawq2/Z9SXFqCgnSxPMVDCZQaDDOuB8dssB5xcm5PtfbDmgz0I/Cg/ruD60C2OQw6LZYNNZsDQpg+bcZDZoMEDtoNpQwWK3mk2H8PphGeWL/oa5VBjxmfIw8sX569ZJjXwIQ8xNmr20d5OBDHE4aV4MrURm2LidYe30nSMo3Yslu3WT0W6H+W7a3TO7aS+9eMSo3m1HdfSNG9WFfrCT0myszqhx/q85WAtq+2GXx60eGrdsb3UA4/CZubVQYyvLPz/EP882WJGJeoOsq6CodKiTXXii97PYChoyQ5f4+8KDL0kQHYv0/Cffux0icyaNukgG0XvSEIyllw9ikwRZf3ldU02ulk6T7opLVI0r1BFEnmrivS16t3uk96MfP/SnoXMEITrhYTlhtUdl2NM859aksKso7Jk2Wf8QAifcsWGh7yHLRk2mq+hF6dy0fU/TWSjULvJomgKMhD1I2aOtwhrdGbnBshP6VJQRnLNuc7E2I/YkjJ3z2FKdG6eYtvfiqw47cSOUQ7en/ZQP5lpn1RfFh0SnbcvJHYTSQslOjfwNrVl3KRAd8Gwg1qteIBbCU4HofIuBWLNOBlZNDUTvfLosp3mr5XSct1C6wP5agB52HmW6GHRltGfjHHP3FNsFK10Z9fl4n7zW6VVhx5x1l6piEjpbFZPu2YkDTl++O78wccD5UBWbvardWGQtyVAvoWj4T4eiua+GotBeCkWhXQllXbyIzz2z7oVQFODzoejey/jcMeues0cEixMzbi+0VTs1AdO5vXNufAZc8nJneRz2yZpsTD5UkyO8U/i0TqyMnknwIZ2En2pcIkJkPR8MevHWVJwxVXFF0GImkYTRYih6uU2OyEfOwKLFEE3iCLGCk0VJIWgxVarkaDGV5BRzKOC0kWkjQ/laoSCezHM0QfQippWPusmpGjfpVtqag8WotBng881HumUbo812oDYgb2WhZOmMebQwhTP+SvjHSnkF2nMOXnYFW8BLIeGxHWbwXD7oNz47t8IfnKlik6CbOU7phAGEGJE5+i7SiR7ij9c5f7yQ3A7eVaBOh6swfHnBX4668aHCDXUtCE4ZYKcu/kpjwJoh+bGL9eI54pBxEo045D8GiQuQRgqU73zwnZT49MOsQxIBzsgwBKR3ZTzTHAJSOE+dImKlkzGURRKkx0yATC3qWTZXvlY8y2tLtEfEYXHoAielqGcPind5qpRTzqfOMwwcjvNrhi5Pam815eQ4QHZr3/dWBHhY0V++nmX+cQQrV3BKX7Wn3lQFYHhA1dfWnTBZ/sllJ3kaniIzjEUcIOhFJSraLjjA2zMc4JalskcQPIQRnOS70SwxEvJ2A6Rx5qrHElNhh26AnaXUKCUMP4UPlASIvsDZTnR0QPBfywLpW8EHQ/3uITfRyRJKdm2WnqpXSK+omqbXqDcQImrWhCrF0JsVQ12xGOrrVgyEYDAcSerDYnF4/L26NcP9H1D56AEdoCvY1XyHUvPM42p4+AfR79hpoKLfVeExbR1phkI2BEKGAzE8CcvwbTyG3EHIjuC3gLauzEkELiYCoRbz2xvd55gNjRiMQohFMuxAxOEYpxnhlkf46VlxJAISTcojDHECS5T1C9qvgYUC1B/FEZfPNo8Znbzzvm7yY/eRKk7RH/jIUdKdsOmQ84jltz4a3Rl+v4Y30RA/3cFuCncjMbhnDHMNMl6b4vuwaNp0XF0PhPB9SxhnCegklcQ/MV2sd0ZqLtAX/4twUGnx63dIvVK4NDy5dI0TsEDVr24ykA9zJunwJuE+V48cidUb2j/67B//IMfzDv8UZiEFaCA3+r9sANhlLcBya5OO/laF3ZR1TYN3jQ+LOQKH45K18K/32CDORGxaiNjQgcwu1jNeyrTGIcn2Jczaa7x+yjvWgzw6ABSc+4fGlR1UzFPlZeyUTEXlpIPji0rVHrAcSMa1fdGTKLRAiFAD8KAGMgD7ptJn2jjwYwNsgAdpZCoWVEDIZgOMxhpGY0A1JKyBba7KjLUglQPvO0jlEFQE/m2mxkaYJ8dF+oJe0BNCZg7JdqGU4FLIJLe4VLFR2lRjMltcYl4ADkCqSxF8KQJfw4wIHwJRojeEiMVYPRlds8hKV4KocIFPMXghKEkEd1meKVA8oyBIVMQ8g3NVhuUUrSnmhi4VYrvvTdGLtvN8i+6UxQffCqTPnwcPXrVQXsWYEtzo55TAuS0pgTw7axnOLijB7jmPs1BhPGNcnlPKGhXVNc6qStxXcKgonHzUtL6kDM4/sRHU4nbNla2R5iNSld0YjmPfuJktUdZghTy80+SeLt6TkVbggivmUaVKmi59HSgleIhkd8pyJwiFuu0gBPGsu1+gqsCYyOTJPCXbAmMV5WQKNeH64g5YLLkIouO5s+BmzTwtrUzSyG1p40CaOJIWZq4BYfxEyCa38kFTfU52XMHeOAnEyJRLtm65ZBviBUnlO1mPQ944LPtnZdMF64hqy3yC50b/khEbF4hqmQdYM/kdlNAUDmMBvzJwDOZUXkl/LeHXavprGb8yKtcL+HUh/bWKX0vprxX86mkpxAg2phLJkE+LaHmlKaS0DZSMiQXFSC3IZdTgAp+61CFuUo5+R+UziDXlKDyMhIqMhLqMhIaMhGZKwSdjoCyxlupa5zw81c87ljzW7rgkmlnIgEswZ3Mb2w4sZy185NE9b/7OJz/8tjkORS4P23XhiKCoHH1IkfqN3pFd7/nb153b+XdP9I48+pPveN9/+pZPPTHA+JWxsrG2tm1QW43aYnw/zzqmxNwXrhOMD8vL/eCyMIdiN1ysNFeYC+IKYFQJJPB6vvJAjgEoNBwcG0vqDlPqmPL6Mq8UCs/QwB0THHnqH175nT908I8ODajMh37Bkc7PvHHvH0T/Ta5UO2BrOT3gENPcUoLJHg4QV988Y6KBGaMm1jIAjMcuE4gCiBpTcOLIn7z6xmO/8d4PPxGr5CCcj9w5aiX3MTo2qQG1kpVTEl3YixXudOOWKHb5/ExxO4689rdu99/y0ScLFal0qNoxkzTWM1tojLbQZL9vx/U7rzvy+Ttfaub3/W/XrUtPzOyLBpiUZR5HiOGgzwG0ZV7oy/Ae58VqjDyapHDQowY1QUbcGyCYdqJP4/3egMaYOBVxsxwq38eSezoDRfkfT/T6uXhB+VQf8AU9WbQVlTqiQpR59cXbcCVjWv1V1/UYtWNIOSsG3DLzQY3RrooBpi7He9oA09KogFsLLvDf58GAhOiZlbLgdDr73POZle7QABivLnzlRVHSVO5Fv8y4x9fJyw/G/LqXFQiX3Gm93wTp5tQBPTmKWtMW5vhG0FUB1V/PzWpQFzMpBEMCtgUTF4jjwQEdWYY9JwZOsQd/ZCeaZK9+ARJjsOCDgovrzOj9UlQPWF4oE5fPlBgk27GQGsLK4ZDO0XysawiX0WIE79X7Z7gUJS5aupmOhJE1qqEwTCuTQ8ResBQ5D2/FBH2Huj94QM8H7JXv2xkK+I+/yTkUnp/3LnZCppRvjHn/uB+szae0/DhoghlXOB/3xJbVd3qWGVGUEH+UZDNcFj6OYEa3hdSD+Bw/WUW0w2+o0S+b1tcZdUAvycv0y/Dms1oo+vQeUxHUY37VdnlHizjQOnszv4sJSqY50EcKPSOxERv/BZjbpRSHUeAVLvnd5GmxtQE/1mLlrobYc7KyxZwmy4ho8fe5KwCS8ve5FwHs5fOyxWLpvriJj7vA97DPvTseQ+VOaggrAaKA86qfLDFNKC5UC05/Q+5+pdzdjytz3pvBMi2VvAAd/pJmCj4Pr1jxaPyomYjujFtcXI/wfVII+5b5F07WT0J1B7o3Pluz7tOcxVkde2mh9nGXA3eDotM0Bkii7A5exXl71CzgNRbW5/woJAJ9BkMmlToDNMM+d1UD4BffLmlsHTygBZC9tKLhRVRlTIHYvkfacsmLo6G+axRClyw326nq7Qzauuh2qUoe/o/upfE6V3/RjaeEQAnYJPuTtnRsoeHVOoQxU+pwTMmUfWbZSabJXmvbawcTSi9ttU2kgC2gpey31+3XJf46RVup3TPbcJTQpm20td+nbcT+D72eAC7LE1wZPqPwkyWXm/2k4lqkypKfLMv1s3x9yV6Ha7+PLd459O0YI4v7Iy3/y26B8oIf29Bu8kbXTFGDGj2G1vWZdoFZNE+51DhNdR4bTHIC6B3M7L0usQUSdB91h1pHvpf/+RumP0hH/Ypmzxc/uSRcufwXeO4DxcRB9srTw8mmbVqk0ramK66dDmdZMxX/tnFG08Pts54M/0Vlpk5LyU8q0yj4IGEl7CFV4zQ1eF085WVvPJUVY1CYstnFn+eyoSfyikQfUCL0eDQky9Xucw61xMlm+LI3A/IKS0yKGb7g5XP/lFec+z0wDeXt+2ZuXynHwqhyLzy/cl9Ke0iqWswhv7hJDnnXXXBH9PAlV55kOD/PXB5XLBM80+6ZKWr3+zQlfXSJLzVwqTfrnnVrKZU7KxBKRLYDjjQ/w8YkKb5I2DdakY6ZxD9yacu0ZH+nsgQ9SSC3JBl1o9vlvg9IxMvD3c746E3RqkByT+tpYbHy92qaYc0ns4tXwxdQxbAg00DzQq3NgRa1LWmLJmnL5Xx7pk1bEOTK2bfZlYvGhPjWHRbbqfzA41y0s250Ipcnw+lkuXNxAIJ7rl1YXFnvzruQ6cD/p2ZvYNxZ9zzj3c1iu+hji3JOWzGkZcnh9fzyLgVKBNO1sBlFoDZc12OsjcPBTGZpDWBp9XNgQPH5qRZkvzvqCRZEk8OxB/vcpwE+DHj4IF/puE+f0iOWN8C7BsYllyXzqnyNbmWjSyhmgdVyzPDCl8polzwHE0oepkb6NOJAThsPYpJnNGzOSDpqr3eaarLWXlpXGE2cAcPKLKUy4BJkwDK7bsMO2mLbGuedZGjgc9HHCwJVIQBfhvc5ZZdXuz4BCi47M8+3YK3HqEWtNxWOr1mAPnZ7JmtGWm9kUVi1uV/ymNxxs4aDinzOk4GzNLI6aqg6Ohzde2DULDRadO+mvcpkA9KrzDZwq20Lz7ZF1b4306HdRzKkxO9N1NuTxz+37CSdlCFvydugNy97UF8vZaIbmvMqK2m/5qWq8znvuXTnrKZYlt1i66rknJAn2C4tVPtLGpj5iVeUXTpa1RuY9oaa8GvLENkt+ExK6umKsOouZTC/URGlqDUKpSh6bpQiNNPLikTDV2dEw9MZvfCe7BtlRMPbsfEIGcgfXDbJfkEEPpcjAsPeYxGBF+RqRUiHLRIjwsxJJ9u7UUkQjlKS4lpcJN9FtThC/soAuQfBEWgBcg+mALlVBsg9D+WvavFVz/ErbontMzUByGXbGQOwrdMpvE0BcgPA77LNJ2D03QJA7qKa2WgSTJskhcaVV57LoHGx0YFoY02qbrFxG4yFy/jDVGcs3CZb/XsMxj4K+1ZxEP/zQ29aYuy8sypDrP7a8KOdIfgri3218uOMfaWS1R9n7CsBpBJQKzkRjn5NPXdR2aDyeocZbZSFBnDIlRh8IRDWN3WYc9cT8iw5d4k+zJYCwfJk68sQCUP4HusdsD8FpC+aZ3xUr8YY9MUGYPKdsm2A8kg8NI/x0KSkMLh4YnZAHAs7Gtl6eXyqSX74XjYVCTHviv66moqEgoeh0C+mhgKx8txlvHWkjfqtayHbTdy9+oEZnPYi3YPqgL5a7DwczijcRXdf3hfcLLabBTXj3iboMwVLFMwAhn8wKQhEr6UyCWbSjMpCbbTqdAFo4mdOQoKEovG5WoZk51UtECoJBryRamHBleLA1WC/3GdjDgXS+sn+fKFbPRR9XF3BBrSixQb0t1rplAI6GxVPyqrFZCS3J1/4zLKTBNbGwwNiyPkhZRCIZARhNHo5NISsTL5dMjj3zwvFLAuNYu5fW96Coi/0N3o2c7CQdDXIkI1csR6L5ei7yAM3sOIvGmzLHl+Bwc5LWt3k19+97DBoZUQoyNX4sx+eLeTt1W1Zbr01RwfD1LGfT6ljPeGGCAdu4RwO417DxmPRn3Hw6T+SgQ+hJhq2Hz7uu0+OsORYwx7KaT6kq8ih+0kLMW4BxqsWYDyMbhU/gJp4BdRhriQQTZdxR1wBAjmirOBOdK+kDyR9hQkVa2l661EgB5gun5RWKcxzEoBIU8V15ISwSMpOODdeGaH3PavkmHbdY4WjVV494OArpA78NbpVcEjWZUveY9Hb2NEi93H3HivgnTJpTvt0dDxMT7J/PyhphitxH9DvYHZ0sIcH4NRKvONY17nifK5djf6rzlnv5+NaFl8X1/N0kWkgXZP8OI88AIMg3DQhwMeoSRGab7xP5TNm4lEKSb6O/3Q/dx/N22jB7cVjVEnuhp4Rwbs2gqX/pxEZjN4afxQchTVIfWvsGrNsdnck2OMHgHix07BB4SPUBH+lzX/uW+9IvohJuYcnZQAEyEJQeAAs52nTAu8Gf99vJkGzFwA+kvXOfS6JWhrJBK2IWtqSeTI5I6zTAdNujz3jJpf3xJ/X0rolyg9vevF4hsW1+kQPuDzwuNgibm1TicOMpnUav5Pxnag+AJEuLKbWDypC26KqVMHAqGDw1IoqMN8LoIyizLx+3cpOfdm1HrxFxoRplhr8acsd/TXYYtixmSJ0RMQG+WLxASSkugacEjdwuCDsd1umdWtMYVmraSZGGgNrkZN0RGQs/rmlDU8inC04yS/whSgXXDVGBgYJeZsChh4OpvUbzNbo8zh5mLKBvFO09bXcWVtBmhJQG3hiAU0l6rjZdkC/FR3GsOQgYo9+UyOTyERoSW6VCBdaIOShKfx/Uyf56MVlJ/o9Trkn5vsUK+l2n0cJ0/OUwDhCoFLvmC3X83EKXMKi69mcxwBK4Ik2rcOH/uNhdZJa74FFpvj7O5g7CI6NUr0KbaEKEIujv9YMGp5gXSrhhCzChraTPI6SDbhkNbOFIsS04haeA0UobgSGf5VwsoUvlsInmNa34M93R5MYutP6DWKSCfbqV68zyWhQgm7lxPhzW/LoRcEICxLmotkWT/EQCCxP+BerfglQofOVB/Q7rK4jSmeucXqjNE7n+W1l9he3MrKB+b1sA/NJ2cDkCdrZ5Va2w4myb7VsrwNAdmDsYa9zSclGp6e6cZl3MS/rCouWnyN6TeuXGanAXvFkwHlbBR8HxVEkS+rBTtPwHaVdj4levAP6FM76TwJvWzCyo99SQsc56t7jbIjQWPEf1Zuk+QTv7q+c5rfZTHnlNE8MUZbkYrtmF9b65ls0Xo/PKjhhAMUZSuIbZDE/BXcDb597KowjfPZCM1awMWmLJQ48+GZBUEmtG7PubcD+AicspxMQXBZ1TrKohGrglLiROLLXQ41SlPsUG4SP62OnSM+m4WjtzLh345vd392Hg2e+eoq5D+3lnhY9I25ad4sxq4eM4/OiiifwyedaKcL+qiDwnhIkdy6TlLMuF5adbpb2pGLzrt7nzokzy43CeHMzw7bjUSyW4zQBjgt5pqD7ADo64jjysSwO+0z0npTM1Yp9zmdENPg4oOItcBsoWRochT6GzWhPXnNa3nNaiBxt0ebiek1v3IHKMG6iPGPcZZxX1Mcijw4eZ6PtbWKUvlxwQP+nfijfW3cOYy7lVAJ3CM4xGqBOjY2FlxKlDQEfiPRJyr7O3WGcThwdnj/skNNhD/WNWS6nWT4eHT9stcws25xBZcFlmP197i2mnuqsK9/KkICXu/+2Z0qmddj5dqo/UzKT1HrAtGjy299eQH+hFgUPmMmPU4Bkk9T69rejcLVszlGEMoZwm2cvq0q211+/XeadTHinbGNWxPcg+hGgE6fcFNNCcQ6Th0XLFEINm5vCFRde7Ptzf9BkWiYLudFpbK1WnH/lt/z0N+Qtj3xD3vKz35C3/Ez+lg+DIAyEe+qBcvo6tcdJzv7RspOc+nWgi3eMTvykii8uE9DFXvRSdqcH1B9A3PUNWO2YXTgQR3piMvMyPPUYDQOe45CUcViQvJEwJh6EpB1mQRriYQMZYo1pJUxdGA4tdpxxOkBzPwxMfKqR/LIIH23TSBTTwjEeLzRDBXS67TM64jIkDjOBlTj892pm0YsYBhrfxpLzD8TjXMxx04QEafK6MU7NZPnTyw4nmqBmcsr+oGbyaPp1jKJoK+bzBOLCQmomzg2AopLoFoFRhf/iYWdGEylglW5nt2OVbO9SgwHTmtM6QO8pau7Vzow7zTQVKDG3XLvQctSc1s65gqdLE93STNvuRnE+PRiDMABth0Z6BZoMX45QHX5sKys3ijEwbm6ExsdIQ7zIQaHEg7e+Ylec7VJiF3CCCk4lE/jYY8pJ7a1dAZlPajAT/B9KCANbsBDwt8iMw0ZgFzGxuuqb+ff+9OdcSs1xsJv4ySeBOxmxYy+NswVBTev9B8SKv1dPcygAggYg2dDC2EU2sY1o3lAH9SnUbUcaDRGLza5pJkvvW3YSBaA3XI/ARt/kaAGaiH4XF3mSkBveXGRMFavDtG6n5KrT+HN1dIOsCx5rhVx4MZws/VjGoZoxA19tWe/YUWlabB8YPdFEjrBfs1MgrPF7uBOuDn0nWaBwuxPtl6765MpcMt89wJ/OtP7UytzmNy+szIU/Dktu8qHFZScaTzi24gJugqaE9enkPHMKRB4r1lCVOFP7uNHd2AU/O1wYHcv+oQk6VY0pJ7nsLoa6K0MKGveFlHLhk3ZcFQp7uxiW6ahx9sgYTnyOpjnIwRsxt0/N6MS5xrm4OHetgwgeZ9r5s8W5A6yUCSktpF1bTnSw+2uhNx2JnqgyB0L0h8oJx5zkRwD1ujv57KIgvZ5UWde6exyxhYGERL8WO8/EYd5cFycw6CajOXpBOCOPG44/eBUEJLTfAN+iTykxnHoif2B7ZausZGRrhNI66fmTtZ98v8RKWFqxxHkNE8yqxOOoTxl0lgyO3AiObDBTRnCak12CpBeDnSdBMoikQt+GSYAJAXOmQ/Bpzl6fNc+/aCfcKqFvyTMPiRlzWsN6OKadcJvEk3EbcCmkGSIdht/Bt2RPUwg3c224mUs6+gMJxBESFs0srDrLxGW7s3jAcnJMm8QJB1qV5uU5gWwGt+druZKWQEYlCxEuaL6QuAmTUS54N3WYuA5NCRs/nyFkwW9uVho0BgrgdVNLYrKgbuJQsUPHkoX5e5j1tHSCbfv2XXCWutYBL10pWVb3XOs4MuxrJ+IyldLn5IFnn2UYXX6CnVDlwXKykj3I91y5p/me5CApVTJ+Irmb0zLVj7p2fRtFmABfXJSzkuhPVbjsqcAOZy+Lf3OBq+qQvsZxjM+WBV/IzaEHqBMsVMe0I5igzO4CR0nZuGLNKmxF/eVk/pV8AP2sOgbrFu+eKsmyuqHOVjsMaA9ung55h3sLCwslOAi4zAHXNbCkE5/FemOuc30dlhe/VuLzOwSKcK4+lcaYyDYgvxvrmhdyKl9S6cTtGp/0Sx1ldJrSJ91lXCZOyWAk2HpTwHMn4XIwur1vMWd14vOp47QD8HmxtfBtfYwtTqF9lIIEOVPwUj45s4k8bs50I6A5JySopAkCJBiRQ5ndtJKIy+BSiDFyDC3zUuVx9vAQsDcrQzcrHHnzzapBHoXfrGpwFmOjQ7HJebyPbmmHW8ZNWyZMR4ODyvshHz7xKdPPqZTOGycbYnd5+P2wcODkwZGtg1yoiT0lkAhXmEc+9P5lax6ZlZDXhVMpVXjILOAuL4Tg/T7Idl6Nr/sRk4nbTKuDK7DKlO2ViK9Q8nMSJUvdZOX3RXa3HBtVxvMYg9jNZBgLr0wceZgbY04hHtaLLqrw3YEK51PWmcCwD/AyD5DCkBfPYBk2zktVw4ivs5ZAZp1EN1mhrBK3mzxwzPhHTalryol7TGC2RahDxXuFpVFUcRV6PFWvdpzkiflX4tixin6psp+yKdXZAE0B+9IBnx/Rtse6cTVFGCw8WkkfDWAIC+qCGahPxIiagGxz58iHdLq+7rPU4j83dUyIEgp7bpjo46aerJaPmarAGFqYom7sMyh9mUtcTWpQUkyQzL89KZ+gICmduCd557seDI4xmMXm97zN7212o9LtdqV2EdAT/Ru4ZiUKj8aIsqxj71FJghPJs+98pnwM0wWf3eSdC95bk+gEV51q0MGplujjMYc0JM+oY4k+nrdkVWKS5fX+0Ov53Z607APSss/5QggrDqtCAC9QMDW/ZWRXV9BflbpT8/hIXktba2IoTYb2rqDejOIN6/rVjmMqyfyr4YbF4fGyClaS217Ll7RcYph2iI//8KpOF3IDUFAkMigbIQlHbnkUHLVk2C9VNVPlfMg7yls5tFApmwM7TiTusYYHUibgd0gAWjn5CkSUOgEgcTeBRe9Y7EmAZ8BTzRJ6VlmWUYk/XltXicqHLQKoYEQfc5266Iy4yZRWbJiGhAeeW+koP81rU5WRCNJcb8KQbYabZaol2kQkhc5khWYMgEp4TSrvLBu3s1dzLxBLOEUa5myVeN3oae2E/6BkX24dIbiO6TqrMiESHeMz9YWFBTrGoQgq+ksVS9Q+YwskFd4gsXuLA9RTcpPmsWucd75/7lpHbNoIuki8E8bl7Uuy/DBAqbMn5rtJhZyj0WeRrXqubH/n4ReQbbpZISd8TKtyXuukGotaZTz2NYDhG32Ay17scwFKXXJBC/tAl3yDNy/+kfN9xsfHW4+asqxtX3C+zwSJOv5S57H3z30zHNhR5DIfrrxVurt4100egGeGkzz70c97r6o72XpcgZ7lxzZmDK9O3tE1LoNU5W9yRuZqlWeW7qKZSgbznIGTqOPXOB/hXkFz4YzGVi6pkssN5abt5Ib/p6eDefUOWU74QF4hkmCShUPZlhbnCqJlwJwuRhOLUQD7P0vagCqZwAhSlo0qClVlMRhQGat4si9ZWPgkHP8t0GZZZjIYZFONDe9jfaRE5aNxza5Ipex2PrMdHVJNZnatOLN9O7N9mdllGWxVBssZmtdQ5/LSYuWSKYhDO58P7Zy9OjD1j6BMz/7AsWRpYWFB3wNdVlmBYaoSuu8Ty8ToSVV3eQVC6UUAlPMXl9e/M9kPlSd9p8fChDkN8uw0ezd6TMAA2aIRwWyztgi+OnuBk8uWzSrmZi9xReGyEsuh+gyUdPswV64ilavmpYGBFs9VrUgKQgrCWeHvRde+IsXsyF6YqCbEvisFIwGBtSp8uLdoqBD1rCZqW5D60tW60Z8pJ2xgn/MlzP42VCH++Z/xk/DzjgyzQBggP8P6n0oefmjZEWbEBx9atgKSM1ei4PHhCPS1NimrwSn8jJJfgisIKCCTLz4k6lvDSf7+J5ad5H8m/jnuJP8R7/+yk7z3oqR4TSqaM+wEVjddEc1u4rJOiR10zb6UsW1tEaJkBZYXdvfRyO79Wvy4NshuhGSHSRuThHVHx2590eKpVMErRVW0u0Qn3e1BIpVOsI7n2F2iJvdaB54MnuwSa4m20h87RdBG22flIbtT5KcaeEoe9mWnWEtceZjvN+V+g++nu0WkdtLdYi3xbKHJwS8W5Yp7npzo4rBk7xZWP24UWGndZEzWkXQR+cioxemwd9K4h53XDy8kdhUZS1eR/FXPgUkTJBFj0hzOhrAE1AXd3J0vuk7cfgPjJe9MHStk0rF9xQZV7nRSiaojFbMlRItLBVs8blYakAt8qKIdp5cM4GEOKGvj9pmNXhVu8XDo943TNwpsqs4AaQek+xzf2uv1wk8JrIGUc8C2WHsec/e35i41RQAL43ZGpCgiXhivk2Hg3n3dgBR5HTNcMp9RKwCzAKCIQlpNbsdouWTTlgWYxJT7JhhAmIIQtjzgAgPyIUBFwNsWhJGTmpocsfDMrQcwmdaRxHFeEb/k7zP8kt/Xwrx8f8HUZgEIUhcux2xKEfKd6OMrOPbKAl4MOdiA8AnpycV+Da/wjMgBTANlvXOZYTsSeI4Sw3NoJqm1/rpcUrGoqSydss7CTjj0ch7ekRHmVmg6q+qV4msKXxqH8SrASHs0+n7jDwSuwh9Ex4tuWKSi77EoN/CRf2PmY7V3uCfEC++NeZOvZk3+W8pjAql36AcK1s20rVOC4oEpDWPbloeZdsqj0Z3u4bFRit7IBqMMnIOd3xiN4yllq2OgyZcwbS4PMGEltpwdgmHCrcTd042+J6vmTqUe2BzgJV2c9g9Xiqt0Z10sjl/mAnBfITrftX3Vlqtt6XPXMlUHtmujLyuJhN6D1YhyFPjVQ9H/rcJrlZ8htWjxY7PoKx5jQZck0FtwWvoMiaP5rDoIV+G/yI67S6oAO5R6tS2DqrttAYeK1yILT1S8BgfXU0oQeBDm5Qo+z1k1ACCB/dXDr+n01yn8InkuWejzokjd6B+V9fu1iD6nFOLIbLLV08vWLTjDAbJniUPJemeGcltQ63O7vCT0Yp24OGBITzzYK/FGDgAB+Tn/nLM/75afB+3Pu4aLs6BscS443azwxQIJJtG6ZllUQ+1yUg01zIISD+WbYZQSR2Gwm8/Z0wwLQtVeXwYeSTeKLHAtTzpuLzE1+C9qT+dk8zJULy9yJzUMACxQcgkl5lY5OU1687CoelTmkJAS+YM+7B3JXd24LOe7cDPT0T+onISuxKNCeJtdgKVUkpUsRzS4onLXeGg0QXPx4MrChZDsrG8p/4ngNsp0bYLp1D7NWcN3o1CKDM3ITanXk/N5Je6SA2oUlBz0DR/EdvkSA+UXq8Pz7THlghMawE9yqlTgD7I7JTkIggsDbz3FpsQn3/h0WWODbsL9Fj0N8zCGHj8XMcqQfcS1jzjTuoVH3gEX5qcB4+NY3DA+pGJDBjRb9zjq4fche65T6oG8aPaEgbWrx/982Yn+hzLa+qAxkp+b0uPBymL1ElI3Zcc4wrfImHTd8PewTKoHLFRXvtxy7zIg0dCb15P85HiiOomwDU+3eHVZVWRn51pxTar/COkjj//wxZ/6lf/80esGTEMpujL2E1RCBDkO8LWI8nYecC6iWBcvYBs08umyDMhg+KZ1TI74JsdAzsOcF+RZgj2h8EuL77SdjCPDqnMaxTPaZXVjfhg5BWQGvtTeF0dsf0QkoCvxfkjnSTp3ZLoy15FjTeG+7TNOFxQrBL/JMogJ7IsftpizfFl7vZ4kzwPgcCjoy7qiB7g+iMWreOHon83FXtK2jhVBiqviDShILlxMcVU83AF2JprHl7FFHmgSZKDlRTme6shPNsoAwmN37fmGwC+tOAXsMt6hph7kGRoXL+/3pqNIHNphwuBNc5AsMx6oR+UBjMb4d2CqA3b7qJEb15OF+bQqkEs4HVn8L1KLQQq+lNzGB6cQMDeSC/e9uQKvGI9hFv+VvDOC5KTNJXobueyK5u5D5Mk+95ZCbK8MyhvjJi84cYNq4CW0yB68cAfJQjEjjhFJnv4LuVQYJGnmyHH966i5/j1gUG3MWrJhQNQ6eHOX3VoIBp46/KGFhNjd5+6PI5HmY+lCl04V6Ytx8e7nsIJb4gl+d9za0AubNPdfrm/uk/aKaQ7pzBsauflVtS330yZ9yGcbyUL63skR70VnTBb74L98/ftgk8b3pfG3jG78ylDjT0njtzc0viIM+8364LMb+uCzV+gDiJWve+N/9gqNj9k/1Ph/+Q1r/Ko0/tbRje8NNf42afzO8x35T25o9Se/0a3+5FfT6p/9BrU6yRP743B0qzeyVl9z3JtjeNuE1DgD1d2Bu+8ZaO0ObV8L3duIT5DOwHEX8Mz4djM5gOu+kRwAXc/xrrZyRkDUtvA34KhNCY5aW3DUIho/I7FoY/wNmuaE6B2tWVaz2TWrCXfHoDtaH+BADbsmfsNT/SKQI7XV48SQFXUzM9ZxUcywdywd2e//+Bde8uy+fQLSEjFe0+i4/jSLLBicNYs8NNzqLkg2rJZgKf8KqwFtwQWIoHAgXYmBybzsrid33ezuiJJ8ReUWuUJZnrUgJvwcX/lnVQR5y1DS8kduFYSqPU74RrVBXeNy2QqK9sL1OC5amSeR/EEW92fVUq94wUm1nXOBRnCavKGcWg3I7Q3PQ/KHL6h1F1JFTOQHk5rnfSp0PswnAQCs0vCVI/8r//PpQ/bLvdcJQj9WFKjiFXL7CCZDjCF/MVWqHPn0p76reuO/NA8N7qi7VKUqcz86wkHuDDvNstsLt9AJcbll0gjoXeWUyQtXK3K1yqGCJeaqAsIol4SptwPT4JLXhMpLSi9lHcoTT9WJyTzWpT1uW8XWriwRf8flUSUZaSkVAzvaO67c8aRk9g6OrOFek/cqzmYLv1Sxx+McqwG/JMfChRK/qXDBF3INsqX0Ae2nT6/ry0rKdhdI6R0uPSxb7mnyNknNCnRZFi3Ou7SunqFN4/F+qCyxpmWJNS2TexqnRKdNyHGi9zJcodw+zWlPS27ZM+5wboXy2Odt09ouIJdqR04/gn8+fsh++c7HkW40Qcr6t0rnsiMGOuD9e256/56bfuXQkUX+8noe27B/rRsVeanY5jIwXopetnRowHb3n7n4wx+8+MMfPDQYZP16cO4Mkh85/ifXT33P8V9+YgBLIv498hec9tQTgwGs10VRWRaQ26y66JQTYictFOnW2ojZ9DTPppB5BvY44QzQxNkNULNX3xN8VMN+aMcB+U/qYyfhjd7EoUo5WfrpZYd39XfgSOAdicPHQ05y8JmQfX9YT/GSgzfU5fAO0DDkISM4tdlvpR8ExPjHDqt3m+AHYav0qfQGnIu/AadNua//Yu6MYE0FB3QtWXbFYRIHOMYT8w+wDYyOFjT7w4i9mH2z363T717yyu7Qzw/M43d0VmWtFF1p682tdYtG4N5hHCHl4Qqv4j3rYfVDHLSHSsLj5tUscB3yowX9sQfhsSkADDawCgdxR5NXd6PvJ/c3B+EPSE3zg8DTBf5GYIl5HdKnkXknWf7gspPkVI7Re1LrgWxbtbVaRRaP1j5mzy5O80mL6Bi8Mv2e56l5P7XKREdNKV0+UmCauYEpP2JSOUPfioU8yFBr0nG5/3d7VH4MvZjduqMTl9mPJh3pWeKDv9uDk15JpAi3zDnQ2qTPLj0xYIRR2aeXGRYcU5FhwdOtO7ClS1B44UaEb8HAhGz/jX4IyNN4uMRWRpHw+ZXTfAmzvSRYzyWJaeeodbb5cg6jIII3Pq3kafFiCnIAKQ4KfsY1NfIYmAIyKfGPd40HqRkizi8AyAkplE2OF0qydpUYzcA08NE2TYhvLn+VgkKN7Pur8hRghBvMjprll5YMXmWIhLC5oP04F/80jmhK2RHN0EPouAq8ysB6wpgJbUFQiAQjOBDEYDi18NS4oKx1T1mt0NtTsOf5yaKCUwYigZP9YuQpsQnYJzXoIxoXNlOhRPBEZHmA2sY4RVyim5ybTzNgG3tyd2bhvatrLPSAl6qQaGNu4ehekhUXLXqaG5R7Dlg8loBh4wMyM67PdDZxEuCTWiYtkdPc61KfKCc/rOWzODmsVdIuz+DwtGDxZCmrj0Ny2XkGV3slAC53G33UZFAuxjvKiBPqOKlXGd0xXqKPk/q2upiwvOiHdQ7UW1BAXR6krh2kBYyE6EE9hNUgFtMsqw0J25IwgpeMM4LEVHdMmXyrmZapNMjlSjOM/qtywuM6h3hmyTYKtDxRx89hYyhruGu7dcTsU+fyRfBWOT4choOQJr/K0Rx/sbLyapzVuzdJrINcUPccwGc4wl92Nltu8g6Pfkzw+GPpWWhncuAv/ivwoDrWCf9EKX8+dZLj47Np7UlwP/vuM6Y+u5uzgzF8kz3raq7Yxdpehms++0/sOsZe9l7yV2zBKyWl4+TfI6e0ip3E8YSPy/oaRyeHjt1jfdVWEUQAeZjUjhce8IYecPEAlZLx48nCwqpz7B4JnfDEiwCkP89NseOxO8NrssiJwKi6w40iFBUcmRPwBYm+id6rjZN7/SR0D+ZT8sR8N9l2Uwd+DHDM0fO5s6GWFkysOJJmlaXTqESfwOHFscS5oWv4wAuBEalp96ZOrK1jRGBjRtKa1VK/6uhHdbhUkrN7QRYbElsrh8CkwawUEJq5jv5mUwZVqVAO9Jk+opPSX1/jnBc4piClXlGpFMpFzE+IvIGHw0AOWc+ywij8CwOhX+gNhH6h18shcMFzUSoQx5VyHIx+bN94MsuqJ1mdslktrsuqklk/kVWlmFWVBaWsQqFkdlea64Lkep9kejfcKnoGO6Qaf/T7saxtZClmbkwfvI0fuEWeu1meA8Sqyx/9vgRoXLnlHtZHHr3XOXndF2a+UmxCAJbb6+94c8d8de0w3KTr2uG56r5pPrViPmGhPW31rtzjA2R3eUnnjz769gU2aSjL9EFhrNgva/e04PuTMFa0hbEiEm6L1A2hcAR24dCbr3Xm0mXxw1pcLzKFMT1SUZZjKBfiRz536duW3vUbL/6WuJRMw7ERLpwJENWP/OFbDv/1D/xy9xNxgDv2XJVPf+CsA+6y0+npD4JK78sOZrPTqpUnBqY4gLFhrxYaHZaVAZUGPXayyLZbK4cGvT5cGkpSZcYqAvdN22oCJezU/AE8OgpuD9iyK6HIkVUGZGRIW07OZSUtFUr6q1p4P3JXjpR8SEcfsIeOgeEGI6bi4ZXW8II7bUo9OUzsp0j7WI2LY/PIs65VqT9x+GU/9ISpDgwL+r4BKBPof05TTZ6v9zJU4tUnqNJf/2hzADYgn4N0w36fCXbA016FWxWgE2oAPACFAtPpVKXdNJw82Z0MKNzyXE2IhcLCscrtJrIMAQEz8NiGhi4e8luijrQpH5P/jespBllS6916jnzlXfvuvGHynw4NjPeI8Yc2I/7IzYj3GDTI4maE1R1v5GYEDv5UOrL/Lb//E9/x5Zd8C49kqMlHnIP//JXDL/kb7EeUNdL3wc/B3dcHBHk5Y0sqM1sSN5JPfjYbKnZ7duS399//6bf/Y/xyPvFMffx5NrjleI/e/jffEuuELDRkVWYDj91qcuGRdIxp3OnGVTsb7ChW+eg2YXGByLri8rjH1IJbHPzkBiA7Ki4fmMAD8gZSfi/tM+aQEqkAGjDPTg494J720mlj+aMonxwKaavJ2UfyQ9y84Hfo9cwfuS8SuWdMCUPPFWYyMbTgzLVvj3r7bBntAxi4Z5SU1OV9Yr9APfE/MU+aZLvynrl8P73ynrmCg6LDjqmd6GEd/rl2NbbC9w9PWfvUB4pZfGAOHozFLLwOprX4EGFma5nZfl/GDR84TPcZWYzVir6cXPOAgZiRGa5Pp7wnc+9bTgXw3Pvm7gDXybp5WxkYncolqgxks5x6t8A5BOXt2dIUxoSUJ1+4KLc4rj7RQ8ngd5k/0GOqMN+Wtxf9pBavmLjKvROsEyjiN1O17kI8rX8pDETJUg/IZ+UBexxv2ZCcuAAa7yGWD5YVeDIk6hifwPsI76WyjXXfD+xJz/jie+HLLLOWffYDLwnjZxUYigNBTXbgtudar07wwXhU65s6SFM8xnIRDJ8orovH5SPGHZIy7uZSxi1KGXdzKeOGFFJlQEGP6j3oS5hf7mWR3UvjolPMlFXGY0MJbRyUlKgyVKLK5iWqFEvkbV4iD7EWNRCc1XLV5+l52K57JivNHOdCFS5OWETRwxk/VfoSRJu1A6SQ+/xK6z6GWNBiaeu8KR1Z2noovevjeAytM0DpB9H7GXzooLieTQs4zVzMpHE49WPEBPxom4b0fhOboBtNuYOfZCKhlxujcodZFgWgvdxh+wTD6gKqgX+DZgqHs+OCPjRhMwc8bbnDAEGcB64x7UCWy0W+ct4p5JMW62bOkoVtuYMRQuUOZlkFxw4dhMshIKYTb4BFXH0CMIy3d8ThVbLp4Vy+us9dDuMGPnvVuIkeHuDHUmjge1Pw6B3YkVfd554NM4okOR7itobFf4LGQQuPI6t6r6BHSYNHMnGCrHzOskTq8fMTNM74kb+kRqedQ5haSI1B3MjWI8e5nQkqK9gd1YDf51IwsFus6j73ZGiCIdx2N748NuMcZo89laUAGSYSeRAANfIycCR2T454IyTDIsT3ELBOkBMV1mRYRFQEe7jH93GjIhudkDve71iZEQw1X4CEDapQA7yETfASAjyqh5W3us9dDGWphXNigyr9Xk8iri+/oce8XVDKp7E4zTIIIa+1jPMVAcsZ9APYIeSvZEWK0btYYLIW4QuYTpn8rp06WIzl5DDo2vMhYMRMW0hmwc35Q+XnAptXQwG4/6rktD7M0C780c42E8yzVqISj1qIco5QRW1Y1yYho8S47UlNS19ztcIVXcqrw6rl8tew9mQFjm3Q0QZD8d275Ii4VzXuIAN4v+8O43eMNxDftY8IGox4yGMc8iz3BoMhSDLbdqycZlPWlKRpNrz2NqArIloe0tC4g4EMoBKz4PDCt5+3iF42or72ASMItn9b9fT8lowuSkkgpQMwFY6vjawxzJJsywURCJ6gjvOq7sqWXsuB4lMW8K0s0j3ghAW+gL6pDG25q9kT4XDSAvFbP9uY09zA1M/IinAQm6CI6lkGY/LKcYuqXnhJzmsPCtBW9sSkJLXZbRmYqUJ2bcluqyCkbJOk0c+auk2Dn9sQV9Hhla2eW6DqZyAcCgK7h/1qQV3b3qftVB1S1wYQMHkxK32znfx+4QJt7/V7g16Pci0Qk24AXTsfZr1e4ZkaGjsoXqBKr5+dSqIxtw+AizfepzHwyvGaerDP9YeqznI2wqF631T7fBxR7fd7du2+S1brW+KqgBvzlLgNiwV7WcOdviktO4al+z7j8tJ9s+F1eM7sILdDHcynDrvn86LbQbN2sHS72ZIruXF/EIqA56ABuR27QhED97cL46x+xuwU7eHyQtUzu6BPpl1LMfGtOJa8gULodmgHjUuBsMJ3xJXJFukiXznvFAolLkrDL4U1w+2YyhkzJu8exzFXJXvtDnmtWffY1BmzGxv3Ck0h6U4cSvcoYnLAXRT3ifq9QVym3VxSKG9uh6qDPo2T6dMOdFyDJgqjotDjLez2S8UL5GEIDIDTR372GEZlCdS4E8VRieG2naYGfdpCW/vUxqsqgz5xh7d5nHDZYMXeVuCabwOGMG/uqlyqSKN4tI09OnoiLdggoxmfF11bh5YdDXqFudMQNt+6sPnykj7oCYZ2G4qIhglsP2mYxyA6yyIp2UoGwz9jawpCFL2iznSVXSmRm8pJAdiXY17eDTLh9Ii7EmOVHtNm8VbCi8B7aPu8YODlT34x8PR8k8MJ/r8lbFk6ToyUjhOQjq2vWjpO9mnyOaXj5DrpOPlCpKO/Tjr6w9LxirKxhO01jrPrfNJdtwTYLBsz+edL21WG5V9V5F+EedyC/Gvl8q+FhmtdUf75eC5iMZjJv8pG+RfJdAOiuvEgiPIJGcjcySX1XVLSW2DB4ULeLYTEt8HREoWETGwVZGKLZWLruWUio793TLkoEwFA/5TihaXCnT/o87YZZKSDmBFzmTnE7SDUiMbXSRtgUE9sLm1srUQ+mIAmLF05byUq2FSJtPGZebXeg7m5MBbL0OlY2gTWxgBpI7ILpnktLLtaOKU1RSJtqv+mpM2vlgvGGy+1++9/YfqzNc6kJhxWpGGhYbwCz7BDWSC6cSC6sXjYRUIGb/VkeDcNevho9xiYoNI3YZ+hBkLZpfWMTPGFB1+ScHSmCR5jLdi7vUPBI9m9O0ytY7yiRQPjOxDPPcQ55iKg1kGk5k9pEaSyY+TliDfJbnRKS78GedmlvGVMtfI+d5rPsnzehYfYhQd5ot5A7FjLoRB/9qpxg8INu3Sfd+nNDbv0TVjO7Z69OWrPnlYg37OH2Z69WjgZzLcj6Q5+/ZNz2AcXt+44QKgPmFMixA6+MmC+iGq6g/dH7uCrVIlDaj7nDr4yYgdfFTWCd/DVfAdfxQ6+yntvYFI0eWzgW9UmQ8kb4EzuAHx0xA6+2jN11iSCvmn0eadelx28n+/gsQ+vUzXbwVezHXxl1A6+Kfta/19pB88W17+qrLO4Bv9ucf1/k8V1/5DFdcjqOSSsagMSC6wYQXNDpyeNHgwbOiti6Ay/CkNnXQydjTzzg7IVmzZs62T1g9fj/Wb8hRs/Aaxe7tA4jVnjp5hB44o1i8bBOutgbvAUa6c1e1pzZ2brrLG1ZcjI6Y42cjaoLgKzlvvNFwWmewUjJ2RI0cjpjjJyNiE1OvEmZsnKwNTgMjxKvGVzqI7vjDtf4zUNCw+8LlyeVi60EJZxLlcCH/2+nV1iNq0N1Z0TNRDNg4nZxMS0Fsp6ZqGU/DlFrydTDVZghiBN5VswJN/CooXS/VeyUL58A4xKksOo9JlJvCZBFIw17aTeTfZw8MBQqLL3qtSv6aj1E5Kw6ANaTjLZJBm9zAlfKhiUApCDLza9Hk7vcile5oSHiui76cGcSqaTBz+z7EQ9LYRmHGyfFbMImnuq6ud6124nuaAyiOYRrOPOtD5Va1TBo+GXHMcJVCje0NGHgSEbcKj4Yh121+j3dR0UHueZdaxXYzft6M7ovEZg943X1z2Z/Upmv2uTQo1nHT+6zRL3Ocl5OFrjLuA5JJlLihPAgS55euN9eVRbFBW5+abYBVm0LRKp6DEuyoIC1OCotwdpybPMneRkaLP9T6hwaXR2OoWKOu+Ae9sOq7wlOIOPpA2hhc/wNsuhCHCVmy2HYrEucBLCXidR0VmdlQQF46L4o4uS5nhbSpxoSeXa61sfcW9+StyRl/L7Mr45V/Yv551RDBY+GCyQky85lTZN6fIJshS1JPueG/lR5sewnWCv3Jb14/mMo+PvlTTXOTXD9BBco2XQPy7Cy942C1Jys3jhujHIpHcDHoZ73RvtrgzmQSUGQcaZOV8DlsE+d7mW1kT2wmXZdwIJM9ikFvbqCH35SjU9kY/rwtVbR7YID8sLVxqWboFBBvTThV+kNgcCUkPdr6L/ruR4oKdIjwxbOAs0P2daL9cS77ipHBXoysdrwP4UfHbPjsC97pKaYS4SdFcP3XUjQ27d3TUVcBht7OhVu0VjCi0nuY9jym9jB2w2MvXU+mlesYwHfI+nu8p7fyWrkjRgLlT+Xq7hAT7JVQJF+E3rkOAwr04rgR5RKSiXCn+nZL3SK7kHdg4k4ckqlDqcClu0BlBgvnB7IaOpKNFrS0IuzIqthA4w/TOADSxnHuITAjbjYELDjGPBl/Xzi6HQj2FBLaqBgsM8UpnkTUbQZ983+MkwA/JAqKjht1HqpXEJw2qupmqfYzOyA37yzlgER/38lF4u55DSqzcvp4bSq3smeITKTFmDWAbdhylFU7nPgM2k3yToRthK9E0Y/Zz1QS8VoDYyb6rqECzW6iGJb7TtIAgOjvghMscht071NFVOSxRxgN0pkjTSe1RhX3lockMu5UUkCKpRrcfn8V6PdfyhPeOK+KbVhhqvtvmOoVZsvNrmO4ZauPGEcfUJZIAzVI76g4pbZoMUAzhC4Q2Fb5lRX6znZ3nI89P6boXWnS+P6AiFPPNgGiH0zxpKyDsUaFTutwZnG4+15rjTlyXNtP3e5qWL7VRAwvk+ibdOLv0UgIWiv7NARAxa5RZAqxjoyKbCc3+fATJlMEjRqjps8WiwAcnBhe6wURT+J4w3BPVVOuy8nrxC1Nvrj1Hp8Duzn98uGLZM8sxR7YT42J+dddsCwcFmPx+mPXda32g0GFlUR6Cc7A3ViU5IyjSYHNzQ6l6B+hLwpnY3uoureheARW312wXMLg6dWAtdOqysE76Y39gqF15MMXMYxHA/a7upwOIQ6A04cKac/OkPvrLO2Mnr0M8CNEkw3CTB+iYZiQEnePrWFRZu2TaaDOhmiCxgKlufyoDN86kEx/hSIXitzIq/L6BifBdXItl9QneP7hIkRB9N6O8Towl2U+nVQKKqveh74ELMxfQZ6Iy9llOMJgsqN63bTI3Iz1jQPl+g/BhEkS0kP6+H43IkTm445C5lZpCguWzUXTj0ZommJp1xaFkVqn/dMCtpFkgzLMRsxJ5fdHVaOTTEP6rXxe487zdpeZM/LLps/7VFDGRxgcP1tU11GoE1xRjBRzRHexYhdDZBCHDFYcHNBtkhhvBiynOJlwQ/BsO/CuS8VzBLewWzdC4faJjdWPDXvOijzC/BHJE+U0The2BKEjmGMWzKM5LpXtjuBT41EBC08gxnVRJJ5GPyqzxjFO5EbHG1h2Ip3bx8dh/6GeWCupcFY478GGQoaMwjG/PKzL0v0zaQqWDNMVV7upwuNwVO3jLrrx53NSKk8+4+LoUpLGDhhuUq5fSV58sCeFYIDcsrhMo1bMWEZ1z0q+UcMilrBneom3Shm3TWTY7tqOgXtPT+Hif844x6wTrX6k+IXSbbwKphJkjGw522oLfTKQfk+qvC/phd5VXPknVLAqF+vEIC4X28QoInVLiu81mEfLSkQmYVEzoS0tFvaQa5L/G5aylZ1nISmwY+LlQZ/I4hJBCCfLHaTZaZG4YTZ/GPuCF86Y9r+cUGkzQbklyCLptcSUdnkGrR5rrXDcAWVYL1BAEJXho64ZG/V0czeqUqX70ZfbGKB6vd7JWLUTf6BEcezLrnkc49oC9UbVEB/kFecq7eFX5bL1muAo2es8Al4GCVwef5cDWuZQBtZaoJji2osBfhGHyuLjwd9UKlIrECcfZU6qZodqbxWjCvcPGAS44Kly3qnESfBlmzMS34RbxgKRJGuXUttsxNJAdchQcDfnA5EowT/nEhlUj4sYQfaCoAC1a7B/RJGCe5TNGjWsJVL9WtsrHszLjLdeEveRyf4QHN9XWP81Fe2tLn6t3otzUa62LVlK6vu9xSoK9HlZnI3sFpnrfPXanO8toGSIVG8tEP2BB821YcV48h5SUXQFCKfdslnV5f9PlGmW94yWfTdycXtWX9XPZlrCULVUuhpy3vmLCu1dKR+ll5wktWrIs/SvN4Vpp6OsxsX61v5tcLE1a6Y+NYmOg3tXDFBsYVRF49rWv29YBDZCYndB0iJ2thyu5uacbmRpvXFnTy6JPPy772EkdwUm6oS1yue9zSPyEfdh209jwv+oJywseDwJ+v3q/nvfvdB/z71XwJYr/n2VMVUN66ycJ+7IDdZIG6HJ28EGEeqrWq6wCmmBdOz66Z/GmCtT9SfPlpVtTsp6msvcZU155ScchPT8c1/iQQSK9V3Xbc4M8obvJnEDPS7P54LHHi8XR9Xp1PP81E3Nq4apvJeAtLq3Eau0lQ+92ULMqyUwuwqeVC0kkPR8zdYTiJIdJYLKM66elusqCscU2sAT23cKndZV4G6iZRcvKnpLf0tG7TlrXQEVjtLEE3aRTTRDRp0wSSpqfW5RJQy6bIbq/Lw6EJSYHwwHhKjvvbSZBVl2xtFWqLNXsryLNp6o4OUqOO6eU2+J/v6MTtYisw4lMgiE/cAl56yN7T3H7rm61E44l7PFlpHjOqy4Z4BF+5pJgw0Gxb+5IyHfzZvraqzA782ckCC8za0T1mV/GhXfIQIX2MPwbpd+PPHn7IJ9WlHbSTamtPqbWnlNlJTdpB2/H1qrWnFG2nHXSV3FtbVeDPJbwd30PqUIcwaAlDdAeewT3qUBUfIe3AR1U+tksOxf/SKkhBdnVpN+3JCrKHmrSbjGT6lCJDu6kzXJA4K0hMcV4QpOLaUpwWpCMF4Q8zoiAd/Im5IB5aBLXeaV8mF3d1qUMx7SlcHMeSOk4t2rb2RWTxjypu0RbqrP2TirfQBFF2eYIm5fIkuvjdfhDMu/crBgrX96t5937LOJcsCKWjShagKEMFgfSwVDO+8LkVUHSp9FoB0QXfj3EgtgLp8QpV0N3VdKLTXPppwrUvFYKsGECr1l9rmQpEDBYqJ9H3IKuGZNWkJrJqEh4kThXpORo+QYLfTZMKXl5rLX4R2vfLKo7Ez5MKl+qhINyPJeqEEQ5GAsuqdxyo+xFFa18CaXSd6vgyQWPJ3lfFYyMEF7wFKnGTKjZgTiWAFtZzNFZ3aFxGAPgWWfC21lZBVzTBdSL+1UzpHMelhk6eMKQJbkdJWGFDaCwrsEpaySc/k655/lrVvajjcf6yogFWSQ0QdYdwqrKVRn9wggvahBhwLas6B12Ly1HnYtm0FSRpWpR2WFhxcCjDj9AuEzbpqrJpGnDYaBXSROvT5Epg+Fnfq84HPAizwbeSDr4L6eDj7Rq+7O8ySyBGY4lJArvCj2IJkGpMtlK1iGFVqgj2QDUflyK+eHbxqOKmTqUaZJdcruFyjWojVsf66NWxsfYa08SMR2OHhFSEa2O4No7sxqWzIxrDR1M+atzZnGqdMIgjHocyB5y02M5QsZ202M5wsfPXc5HGh4tUx7UGkjakSOM8uKkpH7ZIjRFFgjyXFkoOrf2BYmAyeTX4eyngM92JIUeacU7Jb1pVa6+LQ6ohLEl+gJGcJjBHcXXtdWYMg60OMnMeP6aFERRSi+pZaSi4rGQshmaMahStvc5Kzhr+ROz2FmVJ4zqFtgAmosba60yD0+L0WPIfl/zHRdxL/syqnmXMMwQeezXKW4R9k5pM+dGlMGUw6FKdvwqNGYb3qbGwPh/er+Y9K2bV/fCSLQja1XSsr6Rj/UI61jHofTvoS3bQl+2gD0QGC8FNXJWxz7C/duzXKBSUnxqPfVYl6zJIGnDstDIV/e3ZX8zyxpcjGafRiNE/Nnr0j6+9xkxwh1GTh/YfKcK1SVzbguy2sBCgFk3iY0I+IpHpUyOGWpsVCRn9W63OQT5tHSr41rTg9rJd9jt5AV5AoTpSqMkRhWrBs6ow/rdTYF8d78h8GnYOjf8dMv4nWXavvS5uwuuc2vJjC8b/zrWW4atrrzNbMNomUC7imYuWoSZN0UQ+Pqsy/qdoO7WzYcoPtvnBdj5Mt0CLkvHfpsm115lJyX8yzX+X5L+rmP8UtamVZYxpayapya2TZdyU8e/S1i417fJR70JXRlABKzhmcsSiPzG06FewpSKs/Dux8qNE8S675pqW9A1fjPUc7Rxa6HdRkyaza7LQT+Sr+i6KqUktKlyKQyIs9AYLvRJSHQJyzPFusqKx8O6iXVjjt0CNw5cpMljsd49Y7JvgI48nqRm3LEm4Xex31510VKnkPlns0dnxBE2JsG2LILW0PluoxWnzhC2aknHIvyZJYbFXvNg7Q4v9LpqgXfy4Xalb1CK6vDM765sJHhPSq0+hZrh+zjf8Mnxf8vlteIW0VcwvtTlhunAWU1kWsRQ0fQg9YpKtNxnm1JrWAfYtZmfWIxcODQbxHlbNs63fofTTXJU16UL6ab5p7fXcg6ad3lw5lH7KuEWPY3CbF9E2bmJRsSek7ltkCXsRl1hUdJ7THWpTM8vyifTTbENNnrI1HhYQ/JIOTdBEfq2ZvsrKB86VVbKnFE+6L23Q5l8kZWrxsMpmZEQRXUV5bWm4bh0EvOBGlNVtkqakiB2pW5TVLUIp6LlqEm1Wk2ioJpOb1ySSEkymWx0ewpaOfMuI/t1Fe7Jx0DMQcG1uKDOx9mW7A5yimKXVVKprDBdyC1Jvoymayq91ZDf4JUVXSctuk53UFvkYVliegiDbk4/HJ3oQMR1qrf2dSoXkU4pelDWcNGoqNXdRmxtESrxLhtguFoMt2cWuLzE3a4MwCbNrEN+G9bwxaeNG2pX8Ea8vcYs6NDlcwGhEAVnz2NoVR8NHIPnSZWbL2uuQRhSSOqKdt7MuY6/VoJnUoJm8SDjv3qnZyAKve5xwvcxZT9717zblf7cpf/DfbcrP06b8Xl9X5htfv52suEU52Mcyly4scqtikcMu6GRoqvmeNcx3tdgHmjqnWQp5q2fyrVsqrw/+bvrJhixZc2qpD176ybtTbAVSn7z0kxeQETuE8dE7hIm11xix996CbNNPw6rOGEs6WSKiVBEhST73U59728vTT04uie23TPmN2JQB+IN0N18b2tuHYoILCQWkiXQfMMX75ewa7wrtNpqLNiUPTspHfeOmQFagiOtgjYLQPHn5Dm29UmNIupxmO9bQ7mYJW9dWngPw66rcGsgBISLRUA7ZdjcqZh3yYNZd8WwL31kr1+cj7Do5NlP9K+46eZzynlMxruxX1DHZcfJu5WRoGvnuspnvPyMZXVUZp7CSmIlsizV6nHKi1uhxik3WyHHaGjFOt4wep1OsNW0cp1szFaklilqLttpx2h4xTrfacWpTyTjdJtY23qmNI97X7lp5w5Pvw5upGociEgq0FS/czqpjdm2HDA9W47hw28XAvVU+xkaP1G282c3G2QRZxSyyNVs3zsazEkd230njtgFsDi2KWPNiVZPN4e2hHGx112WNkWoNutHGbeLGTeJObBJ3QYNDacEoQruG9oMNLsiu4n4w3/o1QtqJrR8Vtn47h7Z+DZZ/cZsIO754xI4vWr/Ti+sO16mw0xOrnd3ZtQs7O9nXbbqTQ6s1ijs5dPRO2cnZxreygRp8/ZyPrHfyPi41TbAeQsnWm9gMzo9t3aia53u1XVlrYa9mdhUUdrPWMmPcPxue37hxW3s97ypNY8S2rS2Fb8sIwV6Mk46Lac8aWUwbKvY2WaS20Va7HzE4qeHDrOFp0BmeGjwNdqM5dss06AxNg+3rVWyo9mZoUyAadzsV4DBXy65u3O6zWjSOLtq4hxzadw1Nzna+GciuRWmtOTPed0VDQmXDvmuE6s+ebdK9cRSKki9TcznMtXxttfzwPxQPuVOfFs+4GRSwhX7HMsk8v+JkclMnuYizyd/js0kP3kNMeA9/870auvc6eN70BPxdkd+YVw94aYDISsDgxUDMTW7LEQDqTlKONbvB8DQQfkBePKDLuwxNbD2edDL9VuMmX1j5lPhsWY3bvcY5+devbniOo1wnBOEzeYm+1tmTeEk7ekvsJkESRG8xftH1y2Gg7LeYUvFiQCUbY8y+hzTDnNe+HMtjE0Ruog/oFhy04Men8Os2HMMf0N8tv27Bye7xaf2hz8yZcqKpnOhXdXj5XCx1OWzIKnIlwVB0Dug3Aw0PgWgH9IWAv38B39/KXy8E3QP6Lst/rbpG6OoRC6e5WtuZ6EDBW/QUoCvVXnd6Ri/aF5KO3qf4qn64dJh+eEY/jJ/+Ab2o8jd9SOWv6sn3S7j+qOKSuq+oQ0NYBMdn9E/oGGUDsJMf+cCyk+xOHv2A0IbbVA5SqWl+x7R+WImnhNqrF0vwbuOrp0oH9EEZhLcZHnK3MHsX2iFa1hzZ+d0gRHhr17Dj5/6ZlB/8INOeczE4AsB67ysOGORuHdEoVGiUcvTfpGQluLuhLKbEp3ygtHfsQabL/cP1KZMTndSWmXixqFzxYIdfY9YkXO9SXCEF79sSuV3jZB1VsmWSLnHbM9xEts3eJ+2iGGfEuV6cZh+Go6l7HBMhiDXi7dl7T07u7asRDo8BheFRugFRsT6Vuojil0ZXM+5d0ul3c+w+bVqgaEOBkn9wsOddV7BA3lksn2bWcjeL7o+6NvyWWR9GlK1qy6YREO4Lkz32+FiYwyRIFvxou5TuvUqGTM3UDuiT9kdg3AP6QaAQ1PUcUBS+jUfPgwrRdvb5S5zyvTj8ufzESQV/dcWY/Q0qn+Nj1kXVZVNElCjxTnHhbxLyiC8MJi0luRhIOzkz/09x3wIfVXH9P/fuM9ldcvMgJBDj7PIwkUB2N+8Q2GwUlEeBH6KiVnGzuUk2bHbD7iYQ5RGUIj6qlvr7KdpfDbTWR7V/q21FRbOiVmkt4tv+tErRqrUq+Gx/lpS/55y5uzfJ4qPq/5/PB+7OvXNn5s6cOXPmzPecgzMVZkyKmJ7FIDZl8otWQUwpRyc6YgLi4zIQEyXA5zMiMK9LgZKbde5GJyndYzPqDNHR1TwSpRY7Oxf7G3qf6YkS6JCGcb/VmT/CA4umtaGmGvwDpjThA54G+ZZQ2xiwr6jIPCg9z4/hJXDsLaTSgAg9guVlROLut3JZVCZNN7xoBWloumG/1TkeWklulrO5wf8yRHUNuyBut7MQY3gDuoXYAjANbvC/IwK/Mgor6ypa4tCm+AReCCf3uJrIQoGCnQlDBk6BdB2KMd1SLK0AdWDS6kmIte2iyCn+8nkoS0FUWZehi0KhpfpoPE1HXKckjKxb5n/iBU2ky+cmpRyOI/0DpnCXoLkBE3ZoLnCRXO5A9RCARan1Y11dwOpc5D+iFep/Ahjv+8y/+b8E5x0H02kzTqdx3EEcUio3dAqGK6z36iHgsFKOHeikzhRjIWPoCgrSi92mgNuwjcRh7DrmtgLf8hv9dqUC1Ax+d5d/ilCVGBrZFPiGA1awcTLaOrSwBRhKeKTXn5T/EAX8h8hIa7WiemTeQGoCt8UNXTD9tIcCxiQPM5kN22Rm+29JMmxEecZp8BsJzo0hBwqgImMqHs4URE5xYxdGMoBgPoD4wBUOonhBsB1jneymSUVl6+pRxG9l2CZz8iOcqSCbzT9wXZL5G/y7b6bBodAB+gAM80R4BVhxGT2yC65GsTpkWjNpjbOKuEFIxkqDwQphDLBDUj9sPQQ4vNokDDGAZjWFbpn/GthgVCP3lWvlK0yAvK6Vt5oovRmun8luA3CV/CU4a2A5LcPADAOmLuUhGQMGPSxzEyjZviAGCRDHl4tBcifi99FZVDaplY3QokdQKVsrJ+FqEP3/OKj0BlB/l5S7lD0yqigHTCn2hPdTt7TbGovCPhkwEenJBCfEO/NQ5QoFyxCuwYgsQEIWIAELgDmPpt8us6iCUuD9XHNlg67JzWhcZ0avBxB+PrVGQ1hrQctaRcewUqAXBIHTlwhWYfQPZEOPbTYZLQAcoLAQBywphKeRVmSwLUNJRbYCzepgkxqnT8EmTQQkRMAgwP/SPamffbAkhBEvKiWAIZgJ+ggZMAAxRbwSgT3L5ukDiCMEh1v9BfOdNm522rkJPLw606YdTgewADJ8HkQze6WLZyuPoMOaW0xO9Mo1aEJ/S6nn9vRzRTzPxeptuPtXdtDBF7hFcSk8dwf6WVLA6ZUzF/Y5kEDvS7ngYiBnh0sRWXZgFuE4QeJW/3Ww83kUdz52NDzHHTNzYiwjpASr/5Z0HuNcB+rLTKBHgG0S5FVE0yFM6PsSeq1XdkL1O+kbBgcH6SMwmlLOIFzQo0sWejyAJjl4NhBQNrdD/9thRC4EHpnjzNJYIYyIIBTZf8CiaaytBHQC16wsNdJZFI9UEgEzIQCN//abtZVlREq0fSwo9E5ZMqPZv5xy8abRwSg3byg0EN8FF1Fw9CCnzDnEmiuiloHNq1+i8yQwnBOGOAactRIYzZv9AyZuWOU39i1xQIgdMwKaOQlcIpCZyww2MhZu9pctcRjAfwzIJJADxNDVGFRe54gKANxOo2gNiMRiqwmjO3Yd5hZ/gf/ZlLoGTc6KGgz7ZZ1NWlLGERFTSYZziinMFsBwNOTbATfeSygWPci1hvnUP/7Hr011PDf4d12rqwegwyDJuGRquQCiMy7SzNaU4sjIR1MuHbhB2YlHL3bcJxhTeHMErBuJEc8mtxPQKv9P/yvJ/PnciIKFyEaHgAg/N6yqle3pJalWttryMWKRom4/eXLLNvuOHz02K2h73mjA8G0b9NHjyFdvykjZiNZHLlx/kMGiu7kdLssOtC6ygI0y2f6atqcsCsl81ZzRfNX0M9hgjAmtYDpWaAWszYru0LBpVjRRLiLP8poFNpxujrRSBpd6aTNb0/aUoy5qm/HYbTPq22Y6dttMILSD932dp3OyibeCx0MjdJRxB9hlmripVTP648YdKeNkYW1n1MzB0fKKvKGbdXbB31LHsrFOgA8PQRGBSS6Iy4V2vhihCw3/8JeCcR0waleLhD5sWhi4p2E8qy5t8vc8GGvpPb0Jds3Aj9khvHLiRrBdxbgYI/15jfTjxSjqGDDHsYaM3AD+KdD6jpw1oE/VMnDEAO7cDQTON2qWBWguKrIbRmen34Oad4G04wA3+Q3wjDQZgfkG5uEMtU90Sgnir/KMrNmIfNk3nk298RLYBMIZEAhcRr3PgeaTBP/FY2TNactYvwPuk9Anl9kmXOQMGClknkmwyrRrHP+AknKkM1BE2i4TGB4PGJExwruaFx0DNzcysHs0NqDdIxtmhn9YhE0fJN6yCGgZuuFoQKtIgCn8DhWHA2DCYAvrjPiAA1KOJ2TOyuUpKKhzUGt0wliSXSYcd3O0dEZAe4lfntfIiggHUEaSKIdstfIUfFt5DkRQtLDba5QtG20XfiZ+DxTQnnsAVR7MP2BHfLx/wIom7viVeoS8BMpNOtb3HzasdoFrQwhsjchxtPwwc2Td4l423jNljH3tsmWA3NgREu8C+DYeDtKh7/Ah0L/nDL8jDdsbr3AfvLJ/7hztOjzflTu8DOsxIvZ7rAKfK8MfgvSSnaERcDQEbqpSbRnSrogxJHwMAnvsI06gxiEYHn1MIRA5GxuOyN3stM6b8gLqfuzJXVbmkzu7sE9ygbZ+HIdc3D4C7ixwztkC7kznKdlj9e48RwMhZtOBgDK6NC7g0w48+UAvDVT0qOMG8R1aP1tg50/A91uzDdaNeRfKOhs0oiqDoCqjoCqToCqzoCohfhuauZWoyoQCH1JVFhJPhhEZSy8AHKDsaXLSbUvmu+zDy1ypz7PRlzrozFr0KAq2NsJd0QEngAyoUGDfVLqeevSHRuLsNxcR23h+hNDvcQSZwqFx6A7VEcTuIJp15afLTBNrBhotwAbCG+OG7e9/tOCsLfX7fNqV8AAOfAwFjx9eBtQ86cfnlf9eedOnXenYf76rcHiZK1vg+PEdmADOCUi2H0CvQE9g94gOccKx17sSPUYaoS7S916OrvecxRicIpvOe5zoITLDAZ4NTsvyqcfANAW59jic4U5pedHlR59cr11djuEFroncNvwOfMICl2N46fBpDgYoCCxYZmzQr13pBM4hkPfISzQ84jg+Mf2J9AxxEhNpjk6kYzcCSNAlTz8PnBPpoAnIaCJ3KM+jXx8jc060CSi0cwLP5sUE+zaAP6AS8GDY5TxOO5h1DNufWnTq6nuuuGlIuzpt/npwZWNo5lkUm0rUneU/cF2SpQ5kbfC4S2yajsOJTUej2rqvXdPol//1aVcgCPr9V592HbYvuT9g6rj9Tz7timfqyzhQCFpwZQNb0azE8IydcH90/og2BxPTzIG4SMomSQAYNjVp12H7QbXStXH6BU3aNV2fOGQnwiP+bwOac6Q+ZUi7CoZk1+KcpuKdjhNYE2TG2kQmMA3NHRuxPBu3Dy/DM0bGeAkv1ora0ZQSnHK4g06qAaYuJhYyUJrVXOBhxvFcPacHTwLpkq3AI61iP4byyz/NctbG/DR6pUCAVxSBXbEL6IpVIFeMyCxBN2IhwIrVzzRK4VZgmRa0T83Ga5ETJJEsjYWCT0gEY0PcOmFW4xhxvq1joqBykLRcYsnIxfcVgWYhCMQhgCEgdslVKHT2rAtpe+zqNiHz6laknX9P5OM5IIL3AfBEgGJLdGjYYgGKJavJYv3qxsejq1Nqr24lhEmfKrCYFmVARaXuOXSoqGLdi8V0GZcRa0LmkeMzMOoPCCI1HhFW1C3FdAhekK7TTu0Y8bEOneWGXdcOu2iOvh1o5FCQWTqxk8SBp/w5InteyoxK8AjtUH9ki2iUAa+lATXs1JQxgBtE/drokpsuRaGpkMfz0vcmEAwijQnIJYCwwF3nZ+jfsUt2qtYCXsJLCBE0iaDWE4RNBh9p1PKBTlD5QEsCeWbBHESOabvBiJpHaWPWsSdg0RfahprQ+Wvaf/RwAVogovNs/xzEimXRLMqmYc3OMDNsx5b7hFRmRVMasE8U0pqiA2A7dNALkjl4Di3OORlMffL4iIKAxJ25pO83gSaH0ENghzl2KJwZ5GUwVgUFLGznhTVojjbW2WiSqhcwBY2NG9Fyh67J2WObnLIuxd/Iw9BXNMlVejShYyTKCzFL8CWaBapDhHOUeVYXV8QeLKtLBNHTCbGfSEYzmA7rLdpGEAcShUREYdQBWo16QKthtcvU5TLj1EMPAi4LrPmIwuhymcjEC+5Y0o6mskbs7i3ObBAxLDwLbQkttAgLLCda+Nl1ojkIzrAAiK+32rj5GIp5CFCZnQFZeVGeKXuj7ULzRvuFho1fbV2i6aKH+lpJY05RNgnqa8VeAHnLKtYiC89Or1DYI/CEk1CuSc8knrnExsaGOxyxGkPuIvzfinREINNM9q1K5lmWmzYmdSAB7QOWJ5iiWEWEMamd6NR+jKWBZExuG74mAxejD8mnkUMZRBjiQ0AjzrqchWj26pwAgRJQ6NU0dNp1eIHLNnwaqJAd6KKoYPgaiSTznFSpeVqpiOtd5hzPUw4q/rEx5QI7H9cGlwPEZ+i5suH5w8sQzLvMCTuLfPyVb8Ml1VmE8oKzGJcR50SUC5yTeCFaB4J1H1oJZgDJlcK6l8mIJuO2CYfcTgOhDSDC9rTr8AKXc3iZKyeDgOuCdydzQMs5M2z6nA7/Vlmbov6r0b8G8w/sEMK02ASSeT7zd4rJwCfzyWlymII2OlxY6UyBCqfxaXwK/qSdRYpfQUtgsz1WkCR+N57jx04bxshBeWT5ZRcpfsIIEXIadw4v4y4NOTuSPHM0PG9Ws3Ylk2w7won5ZNJSCBTvuXO0K2ZKYbrTCaCKaQKQ50JM+Yj6nDn+W3YmmbPMv/WGJHOWYxc6T0wdmJ0IxHkih1MzXubv7HKVoTE/L/cfvj7J5jngmPJEXg5Pyp2gjMdZa6PVwJWy1dbPwnEpK/McymanS2rf/r42McdCDMVaQTtUzSZaAN2d43ie0yGGGUucRvVPzVC/jR5gtil0mayr34Y0MJoZ2HlpBtq3CYWKYDmgxhoHqigb7Z6QsY3lHZMp7ElaeZRuIK4FLiIQFxm4uziOnaYKGgu8RNjnOHJXghx13KjycjSotk0zmhTluTKqgVw2IFJnDue4IDlxz+O04+kgPLBxjkoP8UDEcJzB3GDvOlaQ5fm8VKgWgJWeAloObJAT2g3tcLoEHUAoSrGRBkLTNDicdvukXMEO0szhXXpThBy98k7XB07yjwKSbOqeK2WjN4U620mXcQTcxwqm6swIqZvFwuXkglCgPw6nZ549DYTVhLPxxDsKUMZHC/18AgKT2hGndHoQxlgLkF+WcZmtBXSfODmDJcAUyoNWjMcRYUym7hT0zSdnMAhwiv0/vZiWvUq0dXMEG8HumDyShHNGC4aTNZvCnLTmxTXCQkX4ctC0BLgMOm1ijoDrk4nCe8Ek4bqgmLvwWsTz8DqBk1ucQl4iXBvIwrWB7VmDnIW68P/Hu3Jp5K5c7LZz0rt12oWT9UJqrw0bLgKh0yDkaYbNpKoQu0izbm+cWfd8DOum7LSrgZQ5UfaIjXMB1ZGf3jFzu94vSmrIbNrWRL9Rh31mqlA7UVsOrkn6inJ0+wSxJc4lnVMmzn8403bviNViA28VG80XShuzL5Q2foPjK+vH05lNgpwt9Z3OtMbF6UgNBXgV035STBzLDFbkUvwSLJ8OYmgO8maQC449iGXk0L4njzhdPmlb9YMuGFqe8OshdM0uOx0LgAsS++jTiFye++X9weRrA1WADNKhGZg5UtbXBSMHihikgxhYhvECHGs2dgPIrHAtJNtYDIQzIbUdFbPbVSTskka2tjhzaycKTZKzBIXKw1JaUtWtr6XOfF7qzOOlYPAlcB8TACLpkLmdoIwoSzjB2seu6ffzU7pkcjPh5MhePpD4cbRHwDo5tIxP1OaRkx4Ig/v8FCk7NbdfI+ZMKTqJwA2w06VtZifAZnYCz3OWcrszHyJj4mHD8SPkRpe2YS5A1SUKJI7UEYQD3dLot8p53E6mFSiRHiYbcDvtauyp9+wjji7wPRsxKmcpt/FC4WoH9nXA81BDoekKkc3CsoYqPDKrKhxpcwVqvFJhVU49mVIO5KT7MY/8qMEakrpXkNqtlZJ5Uh5d7GKCZGATwqNQqgiSEVGnlbpnT6lZxO7PQRecd7nahvOLuc9fJMl0IYJqBPH1NGlXlymDmGjmBpSVXJJ4ZeSJBigNMCiNJNTbVvgvC4JdQdxNehUg/pgRcZEiown+s+BpAkdbKytdILYBreNWfGmMPq7nJO3qAq/y1DwupaobthmZbQkhZLkOIUsh9QReCoBKOueuygj0a8r5r+bpltnqJeDTXFaMxHkRvQybDPwPeDKVitgkBPdwGRE8t0gEJgAX6gTDlIRD8LTvYyvZ/kh0ko4AI4OymhvBIzrcSpnciR8KoAzleZMAlWFEr+N4iB4HE23NrTreB7/qWgZ0rL4LgRxayZAjAABIdDwepYaCv2d9Q1foGnoqGa8zrX0Q/pEbITIE3TViG9ypJkA0h3epwqIufIL1kR/lzwO6Wv3uLwl0vUmWDRQV9TBb5bJMQcwLWGwrf4SRt3IL4HincAvZI0l1cgkscNMNbIRxo8VfJlptUQKfUcrgjyT6f/4kZ5Yu/taOk797/H1r/vpIQcNOwP0j1NpKGiULxbwCklT+CMg4DIeFN6F06CUtlWQAaLFA6BIjzw7iyyVdFObwfGUVEo/TAMvOFHFOg2vQFEBPMG4pl0vqZI6/DAgOAeUdOUS3Esa5hHBlRdziP4yd/XNJg4xT9CQCTZsFkt9MQH9u9B++Ga0DzOB02gxO2I27lG4BpMYcqyiGu9Vlno/eGMz+gVtSvvHQxyA5bwcsHjfCkukCbSJiwJRexFIZ0tnQI7UpNRFFqKbPpwzrl6SMzwdSG79kKXa8iS9U2GoQa4gcwCVjWWBbxZRXZAKLClB5GfqrRTwk4AfrNfzMCEe4ZCsEkVisCEhghEc31KVN/RbogYcAAD12qBh0XId+a+WdSje4e2CE21QIBPWQbJI3yhugIYIxps0VT2YDB+r6H/YjSg2iqpxtl2z+ApBBj1hcRjRPMra8ZVnuYHjXiJEDZXDpYABU6LoubgI/ty1X72MDLhNcNqy/2WX1Hz1qWO1/nUVcWX4pUcl+tq15Fvoo2YDh1/yvs/AqyqN7avCvQ9JvOXr7QeMZgPoHIGBL1goMdgRV+jd0gamI6WaXmZvTdZgzl2e+w2kSof2WAsBwKcWYxII2ioL8UmIGu3lbcyOxbvFl/gJuWKWcQu5t/30kp0xIzl+apbyNaUfoCCoroPBCXbVyERlc+gu6lCtk2AoMPMKEiYUGHqMYFVZ0XlLkQj/HBS7TKjCG7APQ02o/O6XLZfEbILFwkl/qQqItoRDLVvSL7LJotiASeTu3kP9zK3BIA8Gy0C6zxG90Sn5J4MwM/hJsl4ztIttsDJIx5RSEEU/BRnH4r2RUg/xSl3IlNrYMIhJYEBGPTQAYcpfLBO2QwPpEgOIhoxHLRiycNtuywCacaV4RYNsqdbms9IVoR4ZxPeCTDHh0RN8FdjcuS608hc5FIFTMfNFiPxyDw+tvoXlOhZNR3RLYnzAYNXG8lsVlYYBVK2t+NfXGs7C8yV0usE7t4lmQJ8svJzDmH+QBUByWZqePAmc147gR3buNNvM0EJA5Bz3dYDxOMCNg/scfTzLlTZQRFHHrRbrFx0E/jINabU4Lz3YyOBAE3D8wJ2cuz4FLHkL2TNRlb6ULyxf3/5G+hVVyq3/rXio/H14qEGMFO2See0qXC/xmKvMnuUwQBX7+JOqYdXjmAv3DOCA/852K6CDYle5K1yFzh8ZRQWhTDsjCvT6Xc2w8B0rIgTdLR0Tsk7hBw2xjX9umoptwZYvkJNYnc8POQYpXgjEBIWG1TdbSlHfnoMsoMN5aHmZrkaR1xDt1oTkg0HTqHXknhFZMVWbQqjFp1dwiSaZ1WnuoE/VFmXcO0iMLCqoQ8Mi0c9Bl1W5nierN3LJzMJ07xdOB4ncOIkjZOghBr82DqVDjRc0/GfHdgO/mlsFBjI89OpfV1ox2UeWGt0wt8n84RHSXAYxqtdWClowW5XYJDKAyn9jZVsgQX3aELAEVX8+NEGDCROEoTBSOwpQK0JigiCy07A/SEFi4ebAhvewff+zxPsDCXTYj8zNbqyRv9Fu1OF6fvyRK3KDOpQhTcBXm6kYcPmBuIuyRNW1obwKTryW6DxSxc2GJlii+FMLZFUSzw38c/itThlHKFVbEGA8EA8/hd50x0n6AqBHi1GAh0GlGXLDhPwwTIqSllXgDFlyoWdYW889eH+TsJ9QdWUwzVFubEvCMYDfiZ2Xyna8tcplQKLnztUVo+MFOpeBJfjaD3fLaIofI+NPXFmE2uLIy+fbXFvk3LnBgEA0jyU1SrpGREUsjvIjbHuUTmdmYzcBASvIzv9TIfvXaImazgkj0vzKzXZByjSCh/IJ6LhmNNIQJiuAHaJDXB0MgCQs9v4P4PpvBrJzNYFnKxzIKZSDEryUjPgaLrOQflykniW3lMojHtmwSa/4uM1sxGXf4n3o1yfxodwn2G7kyCFuGjbRVxI+jI7oZjIG8CxcwlUFXAXiIL6EpEkgQ8lyHrDlGWwUyl8EWkcwbgEsgOeZcDIxE+2ne4LJwQwvf6rJy8wYXGGNIkMrasM5lauFb1rmySaC38qwNsJlYfkcL38JNLXzr5nU8m1uW37EONmQbgNQ2rFtXZ7Da3gPwuXGDLjpeC3MaRPAs6QGXaVSUrJRjhuUYAyF14/BjbLkj9e6I0FlnA8CkxXeJy6Ar63uwULds/J5A3rcwbm6xbdFKGxjYuNn/L7hXvfXmVf6jbLWy2dDCQOBlLuN66K4WdprLMskp7lrBDLCFLbtj3XoMF0WxsQzUHUZwIiHmUwF6PeA4qMFJcG2dZLsSrRc2jAoQyKV+zvpbkmwdl1rYskkuw83YkksMJHgbsTlopgBFtzCt9W89BuNXvWU9lLJ56SRubLFtdUnruKnFtpUbW2q2uNhmbhLDupmzFt/Wz0Z54/cuXt/i27puCBqJDRSNlLjUOsnWATuBdTwdjxB9Qhzf65LjHAy+wDZSGEZLfeiSAj0TMM52uthObuAih3gO0rHOqv0nGMmGnTrJtliSNgiJMskw6hmauPgZN6y6YwtMtztcxq2bnWi0u1WE8eOGO7Y6IeYabmYk6ncZCKzTINHOoZmzk2nwX/Vx9rNBF3vAJcH4+o/mrHbJ/rusCx2sZaOOBLSfa8ET4tquOy75bNIctcyfBAGOWzZ+j0sXL53EpYuH8BDW9oCkRZ3SBrGFcYZjALRimOQytmCfCjKRuAGEEFM/N9Igm3CQzSMH2USDbEzFiNS172IcUJdl88ihN+uGfh2OPTfBmEubuTE15hKMuUU35sfoduztLTA00P1bNyPDM25BP0U4FluccgtzSqO73fbG+TLzgy9A25GVSakxyayBBO+OxhM8yQrj4VBQ5aFIm7qWxxOBWCLOAwmedPDW3gRXI22UZCJHtDfBo+28NdobaYs38kSnysNqhIfiPJmHb8Adygr3WE5HqA+eR3ict0djPMmSJu2HlS/m7bFoN08aeSKKdxoX8zWhRCdPsrxYINKhUotEgUmXVj09g2Ko9dF2aEUHvqjQQzXS9pVes0QjeCPJkgY+G8oJxONqLBGKRvj5YbU9wZMKj4U6OhPn8/ZAKKy2NfJkVjbn8Ix+4tNGnmSnBgORSDTBA8GgGo/zAF/eGVMDbXxRNBgI89MS0VigQ+V9gXCvytt6Y6FIB4/GeKA9ocZ4mxpPxHqDUC8UlZTh/zworVVtj8ZEj1TwJAtGY2plPBasDPT0xKJrK9VIItY/MxZPP+iOQjGVwU61tT/eqfZlehiKJNRYTzQciCTgcWWsN54IVtY01Lvraj21qqc94K2pdtd5q1vbWwNBT3VbXUNdbVudWh2oqq91V4ZDrbFArL8yEA5Hg1hue3diRD2idYFIR1hdGYyGe7sj8REZetRIW2+4t7tS9/DfbUY80YZlxvvjlfH+SLAyGgmqlZHoygSOQPyb+cR4InbsT0wE+sPR2NepKFUuUmllKKGOrC4ciKjxyngwEA6MfNAejgYSohkxtY2oKMOrawLx7m+kgUE1HP4mhotGpzIM8yNTz0Z6u9VYSDyE1tPD1tCIzPFoLBGKdIy4p4bDoZ5ECKpQE4HKiNoXCofVY47e6PIr1bXBTuAa3wxRCoLMVH1bNNYdiLSt7ImFRI6vT6exwJqVfSpM9bZvpkAoLN6jBlcC214JhLkyosYTalsGImuPxrp7wwF4ksxFrg5cOMAjvd2taow5kKfCLVwNJlTwNZ2hYCcPdkajcTXOQ4k4j66JAANczBw90XgoEeoj5p2cqGUOxXmgNUqrTiLAZ3M3mxaM9vRT+3D6NPJ4tDcWVAXLF/y+LDm9nLdF1TgHztodSAQ7kfOGIgHk+KMyS+VMciUlF2Nsj1FhOYyxJz/73TIqfYYuHWCMNY5KL9alVwCKb1S6ZlR6EWMsG05zTQorYoxVM8bmMcaykGlHAmGuxmLRWCNXIa228d5ITA0EOwOtYZUHo21qIw9F+gLhUBtfEgni0pFQGWM/kxV2jqgvjzF2ulFhSxhjz8qMuXTpj2XGpunSkwyMTWCM2Y0KO5Uxdq2JsXFgczrTM9PNGLvNpLCljLESxpiJMfwO7VxbYYzlivq0P4kxlg99A8PaHUjA7OWJWCCU4KHunrDarUYSNB4xNdEbi6htPBChb+ZrOtUIChu9kTY1Fu6HV+OJmBro5m2hNhhWxo6XqZ1XydTOufCm2+Otqq6pratvCLQG29R23Zk7/CtgjM2e7Xa7PW6vu8pd7a5x17rr3PXuBo/b4/F4PVWeak+Np9ZT56n3NHjdXo/X663yVntrvLXeOm+9t6HKXeWp8lZVVVVX1VTVVtVV1Vc1VLurPdXe6qrq6uqa6trquur66oYad42nxltTVVNdU1NTW1NXU1/TUOuu9dR6a6tqq2tramtr62rraxvq3HWeOm9dVV11XU1dbV1dXX1dQ7273lPvra+qr66vqa+tr6uvr29ocDd4GrwNVQ3VDTUNtQ11DfUNDYFEQu3uSYB41RbqC7WpvLWfX6DGoroHwUA42BsOJFTszpjaHQC5KUaCWADfi0djIBvBi+616Q70t5x08tx5y9T2k9RwmAfCwMT7eXdvItAa7uet0VgsukZtG/1cux8M9ASCoUQ/j/apsfZwdA37p0lh5zHGGgSdnG1WWDFjbD1jbLwufSEDrzGMRSPqjESoGwTOUCIUCIcuIGrpDvRzkph4jxoD2lLbeEwN9sbioT413D/LpODcekmMt0bfr0oMy+8OtfE5MPvheNpANPRLxlgh0Gq647qiIZBsoQuj4bCKqy31GojEc3hvPHSB2tj4Hf8KXTnXizn9sUHB8rLFPHhNUnDedAOdjkqv1KXbgD5HpaHcVQYF+csbJsampmaYdgCf/hNCFgxnW6i9XY2pkYRgdPE+NRyFEXG3Q4eq9D8PRHA68YjaEQAeHFPjiXAoogZiuEDAV1cQAwYecDr+PTf0yXXbt2/fvtd32YenbJsyf8/Q/svvn/jY6t2+a85Z+fz+ufcMdV723PDEX97tW92185p6xy+HzlMXLV38wzt8ms0glXOT79mOhwrDD53hO+u0UycOSp/Oedm6v2Txhm1zHnRf+Fz8E+ccyveoLxf/Nvmu+i9p4qB0oq9/zs9veu24x+Zced1xj7S8cfYcg8U5RS55Y7bIP6SI/LXbMf9QlWke5m8oneqf+8bZD740dPTtCXlvzP5DR8uf+3/Z9YDWnsIwtmco678lbM8V01ffs2TDtgfvOfk3r7z4nnNO959/c8PChlsfeOWt79x50T0nzj7WOBxq+PRfLTPf8PkGGmb9ePcFTdXF11su+LWl4RmDguvCDwUP1dIhkV5g+sEPXzr/wbKeuu+s/+i5rI3K68qS9pterF3x/i/+/vaKazbuSvzw6isn7e2+pC1x0X0Lt0lPhhZUPHbBJT7nU79YuP77/L6rX51wR1ZJR+P6fc+ef2Vv2+JxCzYcOjjBeYKhfdPfj07912On3HDR862P/P6f3Xs+2Hv3jd956fJPr735j1c99cx56/7301++N//c+356zcH1+/xPtpz52invvPCv69/+n9Kh3CcGxl/ieGCa9VDVkT1b7j1zxetru5SJZY+eGWgv1tq/kDEGCJGLH9/b7V75iO+MHv+jpXe27973bOP8DSeb79XynSe+U4N/amjP3Ve9e09fse9elvEv3b8vLX73vds+/T++0MJOb/dTLbuf+Wj+6dLhQ75oy/YL68subqp9b8t7v3h7yDfr8G9333Vkwe5nzlm/bHzykG/XoWuWfth5edOvP7ivUnn5Md/D1zYdXPrzuU0l+3786qqeQ75fvVxrf/y6LbvXjP/w2fdue9K3y3vl0q3nBnbveG/9jculQ77h3/1le2nT95tefCZ0bd4dz/iuv/gS4+mzWVPz7OLBOfH3fPn75tVc3rJld0FL3+ny6hd8+36z0PPC2+27887a/rd7fvuur+YP3Wva7l7eNKHQa7r4uJd8xR9v/33LwQt233jHsk/DR97xOU68aumvf7216bBpYeKtX7ziWy/f0PSrS8/cvXT9Oeay8e/4yt7Ky8/dtnX3rB/95pH9yp99m7YPXHfpD77f9Nuftvr35/7Ntyf5z9Iz/rS6qbRl69vH3XvQd2eX86XVP7lq9/cqf/Bu54d/9ZkL+x9lT2/avar+yU13L37dZzq9qzT87sW72d5zz1buf8v3UOKaOQeCW5scVw0VHnnyL77Lzvxbz93hS5uOd57+23+F3vQ92nnFk8+d0Ll77U2vDPTNetO3M+9l88VTYrtfDX487XvSG7793tcP3BTe3KTNV7qqIm1q0OYvXaUmka6fOEjzma5ds+h6W131Y2fgfGXhl7+/ZHz4fkpb6l8/+eOOz+bvnKwPnjLPNB+5T6OLrO5b8uflvTH7wSsTTxwou6pRu3/8rqo3P3yza/bv3xq3Sn3xzw3a/QV3uHseW/bXpvDL587btPey1P0z/Zvm3fBRa9NoCox9/PInV056Ydbo+xPrC/N/FThlzP1bVxb+6YkP727MTM8HxvALjf/Qda7ot7/UTyB+5Lvxo/k3fjT/0P1Pn7D+6RPWX7SL+unTOXRtFP12Qd13b1wL/GrO9bcuOSd5f1OqXde9+I9DwL/Mi/581t5f7En123+vS96SaLh19vHDMy+Lnuse1W8nin7bkeqfa9ffG1x70c/G9M9UWf7p9OWlY+6f9o97uhv2XT2mf9Z+HCs+XHH0GP1z7Pn/px/94Ynb5Dt96x7Z++nwzaft5ufceRuzHvY5X/rbjfdGfrj7/afZH27PTvpemR8sKH/7tN3Rlwpvz+aHfQ9Fz9y+5IaB3X/6j9trlSmP+06/+4pXX245u+nTP9Qotace9pW88+j9ty398W550/4/PnHift/4uiS/+7qzds8L/M7084HDvqvq2o8UemO7w1cXPvjAac/6Iqe9OHfTC2ub/uf+Deadew/7PgzMHnixaVPTvKX7co0/eNH38su3Hnnu3bOazjqnM6dt8vu+ZcHOtg2TL9otHzl69KiBvuU+A8n9IKNk6eSf00Rat0BrGyS20KCw4xljlYxkdS1dJvivPr1Elwb4O5TdKSuMQ9mijn27Dl40wIPROH/y0oMXDST4dF62b9cTlxy8aKAS75TzeCgiHp4ajcXDaj/3ur01vMxbXsHLqssrhCQZ6Sfd1SyUM0n9BGIIvL5vFz946Va+b1e8OwCiIuzF452BWHc0Egru27WyO7AW2lDmfXIgUblcKxLKUdcGggkQ80LRNr58Uag7wL1uTwMv89SVx6IJIZ7E1Z5ALJCIhda2R3tjITXm5YFYEGqOtmMx7aFYPMEX84Qa60bhCKqqXFjO9/2Erz6vLHJw67Y9D5RXlnkObt22+rwyL9zwlOO3l2mpJwd6K70Ly/lsvorHI7xX1xivu3xGmddb3qqGo2u4p97N29SONZ1qTOXrIPPKxev4HO5pJH2op8ozs6YGstB3LuazuaeCg8ilxkDyFAWQ+jUQ61BjfPEs/jmfOwPls4wfWj/6E7XPKfNM131pxk9N19mIG3bYpCE5VmOhBzcNVZZFtHK0MiLw8sLyBYFgtDV0QpzH1VhIJYGUXg5GKkCsVjtigYTaxstOXvSdedzrnenxzPRUiB9V5bP4SZ2BYGeoP1rBA7EVob5Gb427eqantt5Tm/7+RCzUEY1Eu9VETE9IfN8DicqDW68v8/DpfN/90K49d8HN8gq+74E9d/HZRNF77irz8INbt3GPe21lPWReu+euSm8tkPa++/lsXuatrlq75y7M4631uteWV+pv1dXXutfy6by2qra2tryCr+WzObViz12nBcKBuKCPKjfMlapq/L+mvLcHR9mLo4xTYkY3UmwigBRLr5Z5q8shHw1pNAabtlCEdzfyuAo7ulhFeruc6AwkeEcsuibOA3Gkm/jq3kBM1egftlHpBlXQnCANjqZ4bg91zOS13byJu2d6RaNm4EGA2ublgUQg4i2L8yAPRqCbYDDjkQoeFD0BPRKP7LmrnEgaH0UqIFeGL4AjB93k7gzE1cZR35JS3sBHCXYQ6lbb1FioT23jOLVwMum72VtVXsFT5OSe6ZlB1yqkO6SsYG9rKJiuW7AparOeUeFHVbv37dpzd6W3umpELWL86nD4sBEwOdR4MNCjcpgrMTWsBuJqG7UQNlS8Ve2PRtq4p9oz0wuvVcCRQJrLRdRYRz8MlscrMmBDZ6zuDUUS/06Dge53Hdz060pPlWcEJQIJehvKSY29HP8/Ic57ouH+SLQ7FAhDI/btKkuU44xVO2KqyhdrajhQweFGO6ZG6IAlHorQChWM4s9oOw/wnugaNSYmPvtqf/PsCjODzqlAgVN1dm6Bgnq4GwsU1DVJX7G8nxcozMoYu7tAYdM/23+8UqCgrkgr550CBdff0eVqlrqSePaRJPKMV5iFMWYZr+DefNV4BXVcG8YrzMEYu1zcP9bf6PIOifeOfHb9/mdr8qWFCvuurj1/KVRSOgT9nxqfUb/sIdY8Zt9ZKMorVNiVjLHLJihs0mfy2U0T6P6xvpcc6Lw7Ri69awJ9770TFNYKOsIiBfUPzUV0/6uOxylFpP88o0hhl4JOpkhBXc8Xjccn51zmr7niwzHt48UK7ienFivMC/J7MY2vWkz0srpYQV3rl+2/vcXUT88XKygzFUyk9mj990Xfq43v4+JaNpHoeeZEBfW7rRMVlN0kXX74u+TW37+b410+pJXzyFD26WevWu079B787RxaUfS7p5/Kvs138PD/XHhZ4qah67fjX8oAY/L+7L3OZ83J9xckm97bZm2eNzh+20nWD4a+7Li89vET8+6coDTP6zKesPhoUfKSW+/98OQOU6p/itpOvurjlxzJwCV/L1k6eUqz3bvzsU8fKExqz227tg039RiblRua377zuuLktiuuPfB2hT31/rLVz0/+6fDHQyurLe6OmdnNf/nP43/z+LwjqfadsG3Sg9eWfuKj67hkwV7HqwtzDM1bTaQ3uAT2bKBf2056pyr8u9v3hyfwT9sf+V75E/w5kiWPrS55bLW9edPqh3Pe+bGl+XX+n0/bPCckr17WVLvspsnNc6tK7/vxj54eurPglo+nP2pu3pwz5x8HLp6avLw09pPC/c7mp+ZOODfx1FO+yif+2HPppqeGDpQqOFZvlSpg0sL+UaowEOOV4xXUK7uPJzqkfds9KTr9p+mM6+cnX6Z93XOv+/KvuOeuJ3c8O+SxP+y2P5z0iUU4HA20qW2RaESNqR2hbjXarXYE3Cj78VY1DppdWAM0DR4dctMa/f+Xv/67fPab5rfyl5yXX5XvGo7R3q/Lf43HKPfr8mHTt8SPzcdo79fly5av2L9flj9bvyU+nSWuKd04yHHaLslktlhx5nphNwxwGTFHK/gogbqCo3xHkpNe0qvgvZFEKIyzfU1nFA/6YiqchBKLyBJnhQ+LtmjpfZoeQZc+7nP0KVq+58QZ3e8kSv9W9J2WfhB0Qbr0kDjz09J7gBZ1aWhX+ag0nA3ymTNnBuiLQNDvUyOw1Wlro519PNAa7VO5G/tDAy953G63O2M/I/tL7RfgfEloCOJqb1iN0Wnx9Nm8k/dhiX18BiRwaM7zotyMeSp4azTRSVI6dHg03EaHqHOhGO6pq62fJbYtHix5RjAW7VZjxy4vIY4t0/WnCo+oa3jfSfg+9zTUe1IlV/B4PxyHBhOhYJ8aC6uJzkAYxOh4Qu0BgbqvQpcQFY3OMrIezNSYXi7OwGJxzxFWAz3tsWgH3eKehto6rSVefUtiq6qhtGA4EI8DNIMv6410qDMW9iYSAR4PdqrdKOyDAgL6rEON0yNPgzv1adWxVdU1JxPyYcZSRD7wmrLqchjiWCIa5h51RpUYc0rVNvJ4MNTTPzOlIJgZj4b71JWhvh7Y2YYSPBjtVuOiUD6Ni2I9DfXuWfy0YGhpf8WYIpYtrK7R2lTz1fjj0SnEx4xTaZ2cN5XWn2OtY1/0d9ZU4n/qVAXxAzdOJX3cv1ve0FTiW49OpXWwfNrXK2/+NJJrFk0j/nfhtK/3vVdOI/lo2zSFnc4Ye3OawmZ9jfK+7HiM/5bGpfBbGp8J39I4FX3L45WCbvF4NNwLzBlYUgbNdQWCRHFxu8lIZ9t/BfkF1m5depEu7ZDo/Lx54SIGpcYJv5qI9iB/a4+pq3vVSLAf2pR8mDMWUqhRssJKYU8jcARa+k2hI7eLNalA9E8JeklmbIrQm2v5ARNQqktfDm1CPAuBnEAJE4pw73k1VcSPxSJUwcOhVQLJ2ROIx4E5En8muGsiyuEjRqxzbrc7deYPLMqjwwCcJPASWhr6bPmo9Pmj0kFdul+8/7SRaKRUYHe0NND0TF16kvbd6T8hh82ka7KVrrdfj9eBVc82jzynsYp9YYG4X5IcWZwi7leL+4uaM1OjW9z/bvLzqXZp82iHBJmvqfpFeWXiWp/8/PqXN39B/clR9TQf4zqqfre4tnxB/Su+av3JUfUeo/9T9X9B/6/4wv5/w6ggtkySiJb+dfToUY1XaGLbpTLR4+/E3NOnj9OlX4BzVV36uVHpl8VZlj69aFR6hi79iqB/fbplVBpwcOn57MWjjnhK3nKP2DcUi/ZMHLWf0N8nyE1HLNAXSvQTSF4ArsQTvBWIc4FLpw1/BV29yDkpox9B5ghtMwqZP1vI6C12hS2yK7hXvWamwpj/yKtJZlvBjrEH+ry08EGTMZ82jv8XUCyOtCsXAgA=", Rr = "data:application/gzip;base64,";
function zr(e) {
	let t = atob(e.slice(29)), n = Uint8Array.from(t, (e) => e.charCodeAt(0)), r = new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip"));
	return Promise.resolve(new Response(r));
}
function V(e) {
	return e.startsWith(Rr) ? { then: (t, n) => zr(e).then(t, n) } : e;
}
var Br = {
	simd: V(Lr),
	scalar: V("")
};
V(""), V(""), V(""), V(""), V("");
// src/clock.ts
var Vr = class {
	read;
	#e;
	#t = null;
	#n;
	constructor(e = 0, t = 1, n = () => performance.now()) {
		this.read = n, this.#e = e, this.#n = t;
	}
	get playing() {
		return this.#t !== null;
	}
	get speed() {
		return this.#n;
	}
	get t() {
		return this.#t === null ? this.#e : this.#e + this.#n * (this.read() - this.#t) / 1e3;
	}
	play() {
		this.#t === null && (this.#t = this.read());
	}
	pause() {
		this.#e = this.t, this.#t = null;
	}
	seek(e) {
		this.#e = Math.max(0, e), this.#t !== null && (this.#t = this.read());
	}
	set speed(e) {
		this.seek(this.t), this.#n = e;
	}
}, Hr = {
	drafts: {},
	messages: [],
	dialog: null,
	menu: null,
	held: null,
	pointed: null,
	tables: [],
	wholeTables: [],
	sounding: null,
	copied: !1,
	copyFailed: !1,
	singleKeys: !0,
	hint: null,
	reduced: !1
}, Ur = class {
	#e;
	#t = Hr;
	clock;
	#n;
	#r = /* @__PURE__ */ new Set();
	constructor(e, t) {
		this.#e = e.state, this.#n = e.kept, this.clock = new Vr(e.state.t, e.state.speed, t);
	}
	get state() {
		return this.#e;
	}
	get session() {
		return this.#t;
	}
	get kept() {
		return this.#n;
	}
	get moment() {
		return {
			...this.#e,
			t: Number(this.clock.t.toFixed(3)),
			speed: this.clock.speed
		};
	}
	set(e) {
		zt(this.#e, e) || this.open(e);
	}
	open(e) {
		this.#e = {
			...this.#e,
			...e
		}, e.t !== void 0 && this.clock.seek(e.t), e.speed !== void 0 && (this.clock.speed = e.speed), this.changed();
	}
	openLink({ state: e, faults: t, kept: n }) {
		let r = this.#t.messages.filter(({ key: e, undo: t }) => e !== "link" && !t), i = t.length > 0 ? [...r, {
			key: "link",
			faults: t
		}] : r;
		this.#t = {
			...this.#t,
			drafts: {},
			dialog: null,
			menu: null,
			messages: i
		}, this.#n = n, this.clock.pause(), this.open(e);
	}
	setSession(e) {
		this.#t = {
			...this.#t,
			...e
		}, this.changed();
	}
	replace(e, t) {
		if (zt(this.#e, e)) return;
		let n = this.moment, r = [...this.#t.messages.filter((e) => e.key !== t.key), {
			...t,
			undo: n
		}];
		this.#t = {
			...this.#t,
			drafts: {},
			messages: r
		}, this.clock.pause(), this.set(e);
	}
	draft(e, t) {
		let { [e]: n, ...r } = this.#t.drafts;
		this.setSession({ drafts: t === null ? r : {
			...r,
			[e]: t
		} });
	}
	dismiss(e) {
		this.setSession({ messages: this.#t.messages.filter((t) => t.key !== e) });
	}
	seek(e) {
		this.clock.seek(e), this.changed();
	}
	play() {
		this.clock.play(), this.setSession({ reduced: !1 });
	}
	pause() {
		this.clock.pause(), this.changed();
	}
	listen(e) {
		this.#r.add(e);
	}
	changed() {
		for (let e of this.#r) e();
	}
}, Wr = [
	"",
	"second",
	"third"
];
function Gr(e) {
	let t = /* @__PURE__ */ new Map();
	return e.map((e) => {
		let { family: n } = A(e.name), r = t.get(n) ?? 0;
		return t.set(n, r + 1), `c-${n} ${Wr[Math.min(r, Wr.length - 1)]}`.trim();
	});
}
function Kr(e) {
	return `var(--${e.split(" ")[0]})`;
}
// src/study.ts
var qr = 1200;
function Jr(e, t) {
	if (e.span !== "T") return e.span;
	let { period: n, smallPeriod: r } = t;
	return Number.isFinite(n) && n > 0 ? n : 4 * r;
}
function Yr(e, t) {
	let n = Math.floor(t / e + 1e-9);
	return {
		from: n * e,
		to: (n + 1) * e
	};
}
function Xr({ from: e, to: t }, n) {
	let r = new Float64Array(n + 1);
	for (let i = 0; i <= n; i++) r[i] = e + (t - e) * i / n;
	return r;
}
var Zr = L((e, t) => Xr({
	from: e,
	to: t
}, qr));
function Qr(e, t) {
	let n = -1;
	for (let t = 0; t < e.length; t++) {
		let r = Math.abs(e[t]);
		Number.isNaN(r) || (n < 0 || r > Math.abs(e[n])) && (n = t);
	}
	if (n < 0) return null;
	let r = Math.abs(e[n]), i = Math.abs(e[n - 1] ?? NaN), a = Math.abs(e[n + 1] ?? NaN), o = i - 2 * r + a;
	if (!(o < 0)) return {
		value: r,
		t: t[n]
	};
	let s = (i - a) / (2 * o), c = t[n + 1] - t[n];
	return {
		value: r - (i - a) * s / 4,
		t: t[n] + s * c
	};
}
function $r(e, t, { from: n, to: r }, i, a) {
	return n === 0 && r === t.period && e.largest(1) || Qr(i, a);
}
var ei = {
	x: /* @__PURE__ */ new Float64Array(),
	y: /* @__PURE__ */ new Float64Array()
}, ti = new hr();
function ni(e) {
	for (let t = 0; t < e.length; t++) if (Number.isNaN(e[t])) return t;
	return -1;
}
function ri({ motion: e, window: t, times: n, exact: r, quick: i, arrays: a }, o, s, c) {
	let { numerical: l } = A(o.name), u = c.compared(n, r, i, a), { error: d } = u, f = ni(u.theta);
	return {
		key: j(o),
		curve: o,
		clothes: s,
		numerical: l,
		solution: c,
		track: u,
		error: d,
		energy: l ? {
			x: n,
			y: e.energy(u, a).total
		} : ei,
		largest: i ? Qr(d, n) : $r(c, e, t, d, n),
		gone: f < 0 ? NaN : n[f]
	};
}
function ii(e, t, n, r, i = !1) {
	let a = {
		from: n,
		to: r
	}, o = Zr(n, r), s = i ? ti.begin() : mr, c = e.sample(o, s), l = {
		motion: e,
		window: a,
		times: o,
		exact: c,
		quick: i,
		arrays: s
	}, u = Gr(t), d = Er / Math.max(1, t.filter(({ name: e }) => A(e).numerical).length), f = t.map((t, n) => {
		let r = {
			key: j(t),
			curve: t,
			clothes: u[n]
		};
		if (i && !t.on) return {
			...r,
			drawn: null,
			refused: null
		};
		let o = e.solution(t, a.to, d);
		return "refused" in o ? {
			...r,
			drawn: null,
			refused: o.refused
		} : {
			...r,
			drawn: ri(l, t, r.clothes, o),
			refused: null
		};
	}), p = f.flatMap((e) => e.drawn && e.curve.on ? [e.drawn] : []), m = null;
	return {
		motion: e,
		window: a,
		times: o,
		exact: c,
		total: s.next(o.length).fill(e.energyRatio),
		parts: () => (m ??= e.energy(c, s), m),
		rows: f,
		shown: p
	};
}
var ai = L(ii), oi = "*{box-sizing:border-box}html{-webkit-text-size-adjust:100%;-moz-text-size-adjust:100%;text-size-adjust:100%;font-size:clamp(100%,min(1.25vw,2.2222vh),150%)}body{background:var(--paper);color:var(--ink);accent-color:var(--ink);margin:0;font:400 1rem/1.35 Libration Sans,system-ui,sans-serif}h1,h2,h3,p,ul,ol,dl,dd,figure,table{margin:0;padding:0}ul,ol{list-style:none}button,input,textarea{font:inherit;color:inherit}[hidden]{display:none!important}i,var{font:italic 1.03em/1 Libration Math,STIX Two Text,Cambria,Georgia,serif}i.dotted{position:relative}i.dotted:after{content:\"\";background:currentColor;border-radius:50%;width:.14em;height:.14em;position:absolute;top:-.12em;left:.24em}i.dotted.twice:after{left:.12em;box-shadow:.24em 0}sub,sup{font-size:.72em;line-height:0}b,strong{font-weight:650}a{color:inherit}.soft{color:var(--soft)}.small{font-size:.9375rem;line-height:1.25}.number{font-variant-numeric:tabular-nums;white-space:nowrap}.unseen{clip-path:inset(50%);white-space:nowrap;width:1px;height:1px;position:absolute;overflow:hidden}.skip{z-index:20;background:var(--ink);color:var(--paper);border-radius:.25rem;padding:.5rem .75rem;position:absolute;top:-4rem;left:1rem}.skip:focus{top:.5rem}.definitions{width:0;height:0;position:absolute}:focus-visible{outline:.1875rem solid var(--ink);outline-offset:.125rem;border-radius:.25rem}main:focus{outline:none}svg{display:block;overflow:visible}.icon-drawing{fill:none;stroke:currentColor;stroke-width:1.6px;stroke-linecap:round;stroke-linejoin:round;width:1.25rem;height:1.25rem}h2{font-size:1rem;font-weight:650;line-height:1.25}h2 .unit{color:var(--soft);padding-left:.25rem;font-size:.9375rem;font-weight:400}kbd{font:inherit;border:1px solid var(--edge);white-space:nowrap;border-radius:.25rem;margin-right:.1875rem;padding:0 .3125rem;font-size:.875rem}#still{max-width:44rem;margin:0 auto;padding:1rem 1.5rem}#page:empty+#still{animation:0s 1.5s both appear}#still .data{width:auto}.failed #page{min-height:0!important}@media (min-width:44rem){.failed #still{max-width:96rem}}.failed .no-script{display:none}@keyframes appear{0%{visibility:hidden}to{visibility:visible}}", si = ".chart,.play{--gutter:2.75rem}.plot{height:var(--plot-height);margin:.25rem 0 .625rem var(--gutter);touch-action:pan-y;cursor:default;position:relative}.plot.with-x{margin-bottom:1.625rem}.plot:focus-visible{outline-offset:.25rem}.plot-drawing{position:absolute;top:0;left:0}.plot-drawing .clip{overflow:hidden}.grid-line{stroke:var(--grid);stroke-width:1px;fill:none}.zero-line{stroke:var(--edge);stroke-width:1px;fill:none}.period-line{stroke:var(--edge);stroke-width:1px;stroke-dasharray:.125rem .25rem;fill:none}.level{stroke:var(--edge);stroke-width:1px;stroke-dasharray:.25rem .1875rem;fill:none}.tick,.label{fill:var(--soft);font-variant-numeric:tabular-nums;white-space:pre;font:.875rem/1 Libration Sans,system-ui,sans-serif}.tick.own{display:none}.label{paint-order:stroke;stroke:var(--paper);stroke-width:.1875rem;stroke-linejoin:round}.label.ink{fill:var(--ink)}.label.alarm{fill:var(--alarm)}.symbol{font:italic 1.03em Libration Math,STIX Two Text,Georgia,serif}.now-line{stroke:var(--ink);stroke-width:.09375rem}.dot{stroke:var(--paper);stroke-width:.09375rem}.start-ring{fill:none;stroke:var(--ink);stroke-width:1px;stroke-dasharray:.125rem .1875rem}.ring{fill:none;stroke:var(--alarm);stroke-width:.125rem}.faded{opacity:.22}@media (prefers-reduced-motion:no-preference){.c,.ghosts g{transition:opacity .12s}}.c.thin{stroke-width:.09375rem}.c-potential{stroke:var(--edge)}.c-kinetic{stroke:var(--soft);stroke-dasharray:.25rem .1875rem}.band{fill:var(--panel)}.separatrix{fill:none;stroke:var(--ink);stroke-width:.09375rem;stroke-dasharray:.75rem .25rem;vector-effect:non-scaling-stroke}.faint{fill:none;stroke:var(--edge);stroke-width:1px;opacity:.45;vector-effect:non-scaling-stroke}.plot-note{margin:-.25rem 0 .5rem var(--gutter);color:var(--soft);font-size:.9375rem;line-height:1.25}.plot.with-x~.plot-note{margin-top:0}.waiting{color:var(--soft);background:var(--paper);padding:.1875rem .3125rem;font-size:.875rem;position:absolute;top:50%;left:50%;transform:translate(-50%,-50%)}.parts-key{color:var(--soft);align-items:center;gap:.3125rem;padding-right:.5rem;font-size:.9375rem;display:inline-flex}.parts-key svg{width:1.5rem;height:.5rem}.drawing,.drawing-box{position:relative}.drawing-box svg{width:100%;height:auto}.drawing-box .bob-drawing{pointer-events:none;position:absolute;inset:0}.drawing text{fill:var(--soft);font:14px Libration Sans,system-ui,sans-serif}.drawing text.symbol{fill:var(--ink);font:italic 17px Libration Math,serif}.reach,.angle-arc{fill:none;stroke:var(--ink);stroke-width:1.5px}.angle-arc{stroke-width:1.25px}.plumb{stroke:var(--edge);stroke-width:1px;stroke-dasharray:3 4;fill:none}.drawing .level{stroke-dasharray:2 4}.drawing .column{fill:none;stroke:var(--edge)}.drawing .potential{fill:var(--edge)}.drawing .kinetic{fill:var(--ink)}.ghost{fill:var(--paper);stroke-width:2px}.release{fill:none;stroke:var(--edge);stroke-dasharray:2 3}.rod{stroke:var(--ink);stroke-width:3px}.pivot{fill:var(--paper);stroke:var(--ink);stroke-width:2px}.bob{fill:var(--brass);stroke:var(--ink);stroke-width:2px}.bob-handle{cursor:grab;pointer-events:auto}.bob-drawing{touch-action:none}.bob-handle:active{cursor:grabbing}.bob-handle .reach-target{fill:#0000;stroke:none}.bob-handle:focus-visible{outline:none}.bob-handle:focus-visible .reach-target{stroke:var(--ink);stroke-width:3px}.reading{font-size:.9375rem;line-height:1.2;position:absolute;left:0}.reading-top{top:0}.reading-bottom{bottom:0}@media (max-width:43.99rem){.chart,.play{--gutter:2.625rem}.tick.own{display:inline}.plot.without-x{margin-bottom:1.625rem}.reading-top,.reading-bottom{left:-3.25rem}}@media (max-width:22rem){.reading-top,.reading-bottom{left:-2.25rem}}.convergence-sentence{padding:.25rem 0 .5rem}.convergence-chart{--gutter:3.25rem}", ci = ".button{border:1px solid var(--edge);cursor:pointer;white-space:nowrap;background:0 0;border-radius:.25rem;align-items:center;gap:.375rem;min-height:2rem;padding:0 .75rem;font-size:.9375rem;text-decoration:none;display:inline-flex}.button:hover{background:var(--panel)}.button.primary{background:var(--ink);border-color:var(--ink);color:var(--paper)}.button .icon-drawing{width:1rem;height:1rem}.button.quiet{color:var(--soft);border-color:#0000;padding:0 .5rem}.button.quiet:hover,.button.quiet[aria-expanded=true]{color:var(--ink)}.icon{width:1.75rem;height:1.75rem;color:var(--soft);cursor:pointer;background:0 0;border:0;border-radius:.25rem;place-items:center;padding:0;display:grid}.icon:hover{color:var(--ink);background:var(--panel)}.icon[aria-pressed=true]{color:var(--ink);border-bottom:.125rem solid var(--ink);border-radius:0}.icon .icon-drawing{width:1.125rem;height:1.125rem}.text-button{all:unset;text-underline-offset:.15em;cursor:pointer;text-decoration:underline}.text-button:focus-visible{outline:.1875rem solid var(--ink);outline-offset:.125rem;border-radius:.25rem}.switches{font-size:.9375rem;display:inline-flex}.switches>button{all:unset;box-sizing:border-box;min-width:1.5rem;min-height:1.5rem;color:var(--soft);cursor:pointer;white-space:nowrap;border-bottom:.125rem solid #0000;justify-content:center;align-items:center;padding:.125rem .4375rem 0;display:flex}.switches>button:hover{color:var(--ink);border-color:var(--grid)}.switches>button.on{color:var(--ink);border-color:var(--ink);font-weight:650}.switches>button:focus-visible{outline:.1875rem solid var(--ink);outline-offset:0;border-radius:.25rem}.switches .icon-drawing{width:1rem;height:1rem}.switches.units{padding-right:.5rem}.switches.themes>button{min-height:1.75rem;padding:.125rem .3125rem 0}.value{grid-template-columns:1fr auto;align-items:center;padding:.125rem 0;display:grid}.field{border:1px solid var(--edge);background:var(--paper);cursor:text;border-radius:.25rem;justify-content:flex-end;align-items:center;min-width:5.5rem;height:1.75rem;padding:0 .5rem;display:flex}.field input{all:unset;text-align:right;font-variant-numeric:tabular-nums;max-width:11rem}.field .unit{color:var(--soft);white-space:nowrap;padding-left:.1875rem}.field:focus-within{outline:.1875rem solid var(--ink);outline-offset:.125rem}.field.bad{border:.125rem solid var(--alarm);padding:0 .4375rem}.field.locked{background:var(--panel);border-style:dashed}.field .icon-drawing{width:1rem;height:1rem;color:var(--soft);margin-left:.25rem}.fault{color:var(--alarm);grid-column:1/-1;gap:.375rem;font-size:.9375rem;line-height:1.25;display:flex}.fault .icon-drawing,.message>.icon-drawing{flex:none;width:1.125rem;height:1.125rem;margin-top:.0625rem}.handle{background:var(--brass);border:.125rem solid var(--ink);cursor:grab;touch-action:none;border-radius:50%;width:1.125rem;height:1.125rem;margin:-.5625rem;position:absolute}.handle:before{content:\"\";border-radius:50%;position:absolute;inset:-.375rem}.handle:active{cursor:grabbing}.handle:focus-visible{border-radius:50%}.handle.spot{pointer-events:none}.track{cursor:pointer;touch-action:pan-y;grid-column:1/-1;height:1.375rem;margin:0 .5625rem;position:relative}.track:before{content:\"\";background:var(--edge);height:.125rem;position:absolute;top:.625rem;left:-.5625rem;right:-.5625rem}.track .fill{background:var(--ink);height:.25rem;position:absolute;top:.5625rem}.notch{background:var(--edge);width:1px;height:.75rem;position:absolute;top:.3125rem}.track .handle{top:.6875rem}.facts{border-top:1px solid var(--grid);grid-template-columns:1fr auto;gap:.125rem .75rem;margin-top:.5rem;padding-top:.5rem;display:grid}.facts dt{color:var(--soft)}.facts dd{text-align:right;font-variant-numeric:tabular-nums}.facts .big{font-size:1.25rem;font-weight:700;line-height:1.3}.facts dt.big{color:var(--ink);font-weight:400}.hint{position:relative}.hint-word{all:unset;-webkit-text-decoration:underline dotted var(--edge);text-decoration:underline dotted var(--edge);text-underline-offset:.2em;cursor:help}.hint-word:focus-visible{outline:.1875rem solid var(--ink);outline-offset:.125rem;border-radius:.25rem}.hint-text{z-index:12;background:var(--paper);width:16rem;color:var(--ink);border:1px solid var(--edge);border-radius:.25rem;padding:.5rem .625rem;font-size:.9375rem;line-height:1.3;position:absolute;bottom:1.6em;left:0}.caption{color:var(--soft);border-bottom:1px solid var(--grid);justify-content:space-between;padding:0 0 .1875rem;font-size:.9375rem;display:flex}.row{border-bottom:1px solid var(--grid);grid-template-columns:2.75rem 1fr auto;align-items:center;gap:0 .625rem;min-height:2.875rem;padding:.25rem 0;display:grid;position:relative}.row:not(.exact):hover,.row.pointed{background:var(--panel)}.row svg.key{width:2.75rem;height:1.375rem;overflow:hidden}.key.framed{border:1px solid var(--edge);background:var(--paper);border-radius:.25rem}.key .second,.key .third{stroke-dashoffset:.8rem}.row .name{min-width:0;line-height:1.2}.row small{color:var(--soft);font-size:.875rem;line-height:1.25;display:block}.row .result{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap;font-weight:650}.row input[type=checkbox]{opacity:0;cursor:pointer;width:100%;height:100%;margin:0;position:absolute;inset:0}.row input[type=checkbox]:disabled{cursor:default}.row.off .name,.row.off .result{color:var(--soft);font-weight:400}.row.off .key path{opacity:0}.row.off:hover .key path{opacity:.4}.row:has(input[type=checkbox]:focus-visible){outline:.1875rem solid var(--ink);outline-offset:.0625rem;border-radius:.25rem}.row .remove{opacity:0;width:1.5rem;height:1.5rem;margin-top:-.75rem;position:absolute;top:50%;right:-1.5rem}.row:hover .remove,.row .remove:focus-visible,.row:focus-within .remove{opacity:1}.stepper{border:1px solid var(--edge);z-index:1;background:var(--paper);color:var(--ink);vertical-align:middle;border-radius:.25rem;align-items:center;margin-left:.5rem;line-height:1;display:inline-flex;position:relative}.stepper button{all:unset;text-align:center;cursor:pointer;width:1.5rem;height:1.5rem;color:var(--soft)}.stepper button:hover{color:var(--ink)}.stepper button:focus-visible{outline:.1875rem solid var(--ink);border-radius:.25rem}.stepper .count{text-align:center;font-variant-numeric:tabular-nums;min-width:.875rem}.play{grid-template-columns:var(--gutter) 1fr;align-items:center;display:grid}.play .go{background:var(--ink);width:2.25rem;height:2.25rem;color:var(--paper);cursor:pointer;border:0;border-radius:50%;place-items:center;margin-left:-.125rem;padding:0;display:grid}.play .go:focus-visible{border-radius:50%}.play .go .icon-drawing{fill:currentColor;stroke:none;width:1.125rem;height:1.125rem}.scrub{cursor:pointer;touch-action:pan-y;height:2.125rem;position:relative}.scrub:before{content:\"\";background:var(--edge);height:.125rem;position:absolute;top:1rem;left:0;right:0}.scrub .fill{background:var(--ink);border-radius:.125rem;height:.25rem;position:absolute;top:.9375rem;left:0}.scrub .notch{top:.6875rem}.scrub .handle{width:1.5rem;height:1.5rem;margin:-.75rem;top:1.0625rem}.play .options{grid-column:2;justify-content:space-between;align-items:center;gap:1rem;min-height:1.75rem;display:flex}.play .steps,.play .option,.play .time{align-items:center;gap:.375rem;display:flex}.play .note-line{grid-column:2;font-size:.875rem}.play .field{min-width:0}.play .time{position:relative}.play .time-name{pointer-events:none;position:absolute;left:.5rem}.play .time-name+.field{padding-left:1.5rem}.play .short{display:none}.span-field .field input{width:0!important}.span-field .field{border:0;width:0;padding:0;overflow:hidden}.span-field.on .field,.span-field .field:focus-within{border:1px solid var(--edge);width:auto;padding:0 .375rem}.span-field.on .field input,.span-field .field:focus-within input{width:2rem!important}.menu{position:relative}.menu ul{z-index:10;background:var(--paper);border:1px solid var(--edge);border-radius:.25rem;min-width:12rem;max-height:min(24rem,38vh);padding:.375rem 0;position:absolute;top:100%;left:0;overflow-y:auto}.menu.right ul{left:auto;right:0}.menu ul.up{top:auto;bottom:100%}.menu li button{all:unset;box-sizing:border-box;cursor:pointer;white-space:nowrap;width:100%;padding:.3125rem .875rem;line-height:1.25;display:block}.menu li button:hover,.menu li button:focus{background:var(--panel)}.menu li button:focus-visible{outline:.1875rem solid var(--ink);outline-offset:-.1875rem}.menu li button[aria-checked=true]{font-weight:650}.menu small{color:var(--soft);font-size:.875rem;font-weight:400;display:block}.menu.save>.button{justify-content:center;min-width:1.75rem;min-height:1.75rem;padding:0}.menu.save>.button .icon-drawing{width:1.125rem;height:1.125rem}.menu.save.in-corner{position:absolute;bottom:0;right:0}.message{background:var(--panel);border-left:.25rem solid var(--alarm);overflow-wrap:anywhere;align-items:flex-start;gap:.5rem;margin-bottom:.5rem;padding:.5rem .75rem;line-height:1.3;display:flex}.message.plain{border-left-color:var(--edge)}.message>.icon-drawing{color:var(--alarm)}.message>.icon{flex:none;margin:-.25rem -.375rem 0 auto}.dialog{border:1px solid var(--edge);background:var(--paper);color:var(--ink);border-radius:.5rem;width:min(32rem,100vw - 2rem);padding:0}.dialog::backdrop{background:#00000059}.dialog-body{padding:.75rem 1rem 1rem}.share{grid-template-columns:9rem 1fr;align-items:start;gap:1rem;padding:.5rem 0;display:grid}.share .link{resize:none;overflow-wrap:anywhere;word-break:break-all;background:var(--panel);border:0;border-radius:.25rem;width:100%;margin-bottom:.375rem;padding:.375rem .5rem;font-size:.9375rem;line-height:1.3}.key-list{grid-template-columns:auto 1fr;gap:.25rem 1rem;padding:.5rem 0;display:grid}.check{align-items:center;gap:.5rem;display:flex}.table-box{max-height:20rem;margin:0 0 .75rem;overflow-x:auto}.data{border-collapse:collapse;font-variant-numeric:tabular-nums;width:100%;font-size:.9375rem}.data caption{caption-side:bottom;text-align:left;color:var(--soft);padding-top:.375rem}.data th,.data td{text-align:right;white-space:nowrap;padding:.125rem 0 .125rem .75rem;font-weight:400}.data thead th{color:var(--soft);border-bottom:1px solid var(--edge)}@media (max-width:43.99rem){.value{padding:.25rem 0}.field{height:2.25rem}.track{height:1.5rem}.track .handle{width:1.5rem;height:1.5rem;margin:-.75rem}.icon,.switches>button{min-width:1.75rem;min-height:1.75rem}.tools{gap:0}.play{grid-template-columns:auto 1fr auto;gap:0 1rem;margin:0 -1rem;padding:.375rem 1rem}.play .go{width:2.75rem;height:2.75rem;margin:0}.play .short{display:flex}.play .options{display:none}.play .note-line{grid-column:1/-1}.row .remove:not(:focus-visible){display:none}.row .remove{background:var(--paper);opacity:1;right:0}.menu.save.in-corner{right:-3.25rem}.share{grid-template-columns:1fr}.qr{max-width:12rem}}@media (max-width:22rem){.menu.save.in-corner{right:-2.25rem}.play{margin:0 -.75rem;padding:.375rem .75rem}}", li = ".picture,:root{--lightningcss-light:initial;--lightningcss-dark: ;color-scheme:light;--paper:#fff;--panel:#f3f5f7;--grid:#e3e8ec;--edge:#727e8a;--soft:#4a5560;--ink:#11161b;--brass:#bd7900;--alarm:#b3140a;--c-exact:#11161b;--c-linear:#6f7478;--c-harmonic:#cc1f24;--c-fourier:#2a70cf;--c-trigonometric:#12979a;--c-polynomial:#4d6814;--c-integrator:#5a2a70;--c-euler:#b57a4e}@media (prefers-color-scheme:dark){:root:not([data-theme=light]){--lightningcss-light: ;--lightningcss-dark:initial;color-scheme:dark;--paper:#0f1419;--panel:#1a2128;--grid:#2a333c;--edge:#7c8995;--soft:#aeb9c4;--ink:#f2f5f7;--brass:#f5b62e;--alarm:#ff8f80;--c-exact:#f2f5f7;--c-linear:#9aa0a5;--c-harmonic:#f36f58;--c-fourier:#8fb2ff;--c-trigonometric:#23cdc5;--c-polynomial:#cdd06a;--c-integrator:#a872c6;--c-euler:#e6b08a}}:root[data-theme=dark]{--lightningcss-light: ;--lightningcss-dark:initial;color-scheme:dark;--paper:#0f1419;--panel:#1a2128;--grid:#2a333c;--edge:#7c8995;--soft:#aeb9c4;--ink:#f2f5f7;--brass:#f5b62e;--alarm:#ff8f80;--c-exact:#f2f5f7;--c-linear:#9aa0a5;--c-harmonic:#f36f58;--c-fourier:#8fb2ff;--c-trigonometric:#23cdc5;--c-polynomial:#cdd06a;--c-integrator:#a872c6;--c-euler:#e6b08a}.picture,:root{--c-sn:var(--c-trigonometric);--c-cn:var(--c-fourier);--c-dn:var(--c-integrator)}.c{fill:none;stroke-width:.125rem;stroke-linejoin:round;vector-effect:non-scaling-stroke}.c-exact{stroke:var(--c-exact);stroke-width:.1875rem}.c-linear{stroke:var(--c-linear);stroke-dasharray:.5625rem .3125rem}.c-linear.third{stroke-dasharray:.28125rem .15625rem}.c-linear.second{stroke-dasharray:1.125rem .625rem}.c-harmonic{stroke:var(--c-harmonic);stroke-dasharray:.00625rem .28125rem;stroke-linecap:round;stroke-width:.15625rem}.c-harmonic.third{stroke-dasharray:.003125rem .14062rem}.c-harmonic.second{stroke-dasharray:.0125rem .5625rem}.c-fourier{stroke:var(--c-fourier);stroke-dasharray:.8125rem .25rem}.c-fourier.third{stroke-dasharray:.40625rem .125rem}.c-fourier.second{stroke-dasharray:1.625rem .5rem}.c-trigonometric{stroke:var(--c-trigonometric);stroke-dasharray:.8125rem .25rem .1875rem .25rem}.c-trigonometric.third{stroke-dasharray:.40625rem .125rem .09375rem .125rem}.c-trigonometric.second{stroke-dasharray:1.625rem .5rem .375rem .5rem}.c-polynomial{stroke:var(--c-polynomial);stroke-dasharray:.3125rem .1875rem}.c-polynomial.third{stroke-dasharray:.15625rem .09375rem}.c-polynomial.second{stroke-dasharray:.625rem .375rem}.c-integrator{stroke:var(--c-integrator);stroke-dasharray:.5rem .21875rem .09375rem .21875rem}.c-integrator.third{stroke-dasharray:.25rem .10938rem .046875rem .10938rem}.c-integrator.second{stroke-dasharray:1rem .4375rem .1875rem .4375rem}.c-euler{stroke:var(--c-euler);stroke-dasharray:.1875rem .1875rem .1875rem .1875rem .5625rem .1875rem}.c-euler.third{stroke-dasharray:.09375rem .09375rem .09375rem .09375rem .28125rem .09375rem}.c-euler.second{stroke-dasharray:.375rem .375rem .375rem .375rem 1.125rem .375rem}.c-sn{stroke:var(--c-sn);stroke-dasharray:.8125rem .25rem .1875rem .25rem}.c-cn{stroke:var(--c-cn);stroke-dasharray:.8125rem .25rem}.c-dn{stroke:var(--c-dn);stroke-dasharray:.5rem .22rem .1rem .22rem}", ui = ":host{background:var(--paper);color:var(--ink);accent-color:var(--ink);font:400 1rem/1.35 system-ui,sans-serif;display:block;container-type:inline-size}.widget{grid-template-columns:17.5rem minmax(0,1fr);gap:0 1.75rem;padding:.75rem;display:grid;position:relative}.widget .column{flex-direction:column;min-width:0;display:flex}.widget .sentence{margin-bottom:.5rem;font-size:1.25rem;line-height:1.25}.widget .head{justify-content:space-between;align-items:center;gap:.75rem;min-height:1.75rem;display:flex}.widget .tools{align-items:center;gap:.125rem;display:flex}.widget .tools .icon,.widget .menu.save{display:none}.widget .tick.own{display:inline}.widget .plot.without-x{margin-bottom:1.625rem}.widget[data-frequency] [data-value=length],.widget[data-frequency] [data-value=gravity]{display:none}.widget .waiting-line{color:var(--soft)}@container (width<=40rem){.widget{grid-template-columns:minmax(0,1fr)}.widget .drawing{width:16rem;margin:0 auto}}.widget .field input{font-size:.875rem}.widget .reading{font-size:.8125rem}.widget .plot{height:max(var(--plot-height), 17rem)}";
// src/controls/parts.ts
function di(e, t, n, r, i = "") {
	return g`<span class="switches ${i}" role="group" aria-label=${e}>${t.map((e) => g`<button type="button" class=${e.value === n ? "on" : ""} aria-pressed=${e.value === n ? "true" : "false"}
      aria-label=${e.name ?? y} title=${e.icon ? e.name ?? y : y}
      @click=${() => r(e.value)}>${e.icon ? S(e.icon) : C(e.text ?? "")}</button>`)}</span>`;
}
function fi(e, t, n, r, i = "") {
	return g`<button type="button" class="icon ${i}" title=${e} aria-label=${e}
    data-tool=${t} aria-pressed=${r === void 0 ? y : r ? "true" : "false"} @click=${n}>${S(t)}</button>`;
}
function pi(e) {
	let { key: t, open: n } = e;
	return g`<div class="menu ${e.className ?? ""}" @keydown=${(r) => {
		let i = [...r.currentTarget.querySelectorAll("[role^=menuitem]:not([disabled])")], a = i.indexOf(document.activeElement), o = {
			ArrowDown: a + 1,
			ArrowUp: Math.max(a, 0) - 1,
			Home: 0,
			End: i.length - 1
		}[r.key];
		r.key === "Escape" ? (e.toggle(!1), document.getElementById(`menu-${t}`)?.focus(), r.stopPropagation()) : o !== void 0 && n ? (i[(o + i.length) % i.length]?.focus(), r.preventDefault()) : o !== void 0 && r.key === "ArrowDown" && (e.toggle(!0), r.preventDefault());
	}} @focusout=${(t) => {
		!t.currentTarget.contains(t.relatedTarget) && n && e.toggle(!1);
	}}>
    <button type="button" id="menu-${t}" class="button quiet" aria-haspopup="menu" aria-expanded=${n ? "true" : "false"} aria-label=${e.name}
      @click=${() => e.toggle(!n)}>${e.label}</button>
    ${n ? g`<ul role="menu" aria-label=${e.name} class=${e.up ? "up" : ""}>${e.items.map((n) => g`<li role="none"><button type="button" role=${n.chosen === void 0 ? "menuitem" : "menuitemradio"} tabindex="-1"
          aria-checked=${n.chosen === void 0 ? y : n.chosen ? "true" : "false"} lang=${n.lang ?? y} ?disabled=${n.disabled}
          @click=${() => {
		e.toggle(!1), document.getElementById(`menu-${t}`)?.focus(), n.act();
	}}>${C(n.text)}${n.note ? g`<small>${C(n.note)}</small>` : y}</button></li>`)}</ul>` : y}</div>`;
}
function mi(e, t, n, r, i) {
	return g`<span class="hint" @pointerenter=${(e) => e.pointerType === "mouse" && i(!0)}
    @pointerleave=${(e) => e.pointerType === "mouse" && i(!1)}><button type="button" class="hint-word" aria-expanded=${r ? "true" : "false"}
    aria-describedby=${r ? `hint-${e}` : y} @click=${() => i(!r)} @blur=${() => i(!1)}
    @keydown=${(e) => e.key === "Escape" && i(!1)}>${t}</button>${r ? g`<span class="hint-text" role="tooltip" id="hint-${e}">${n}</span>` : y}</span>`;
}
// src/draw/curve.ts
var hi = /* @__PURE__ */ new WeakMap();
function gi({ x: e, y: t }, n, r, i = 1) {
	let a = `${n.key}|${r.key}|${i}`, o = hi.get(t);
	if (o?.key === a) return o.d;
	Ci(e, t, n, r, i);
	let s = ji();
	return hi.set(t, {
		key: a,
		d: s
	}), s;
}
var _i = 2e4, H = .5, vi = /* @__PURE__ */ new WeakMap();
function yi(e, t) {
	let n = vi.get(e);
	if (n?.key === t.key) return n.at;
	let r = new Float64Array(e.length);
	return t.fill(r, e, 1), vi.set(e, {
		key: t.key,
		at: r
	}), r;
}
var bi = -1e9, U = /* @__PURE__ */ new Int32Array(4608), W = 0, xi = /* @__PURE__ */ new Float64Array(1536);
function Si(e, t) {
	U[W++] = Math.round(e), U[W++] = Math.round(t);
}
function Ci(e, t, n, r, i) {
	xi.length < t.length && (U = new Int32Array(6 * t.length), xi = new Float64Array(2 * t.length)), W = 0;
	let a = yi(e, n);
	r.fill(xi, t, i);
	let o = NaN, s = NaN, c = NaN, l = NaN, u = NaN, d = NaN, f = !1, p = !1;
	for (let e = 0; e < t.length; e++) {
		let t = 10 * a[e], n = 10 * xi[e], r = Math.min(Math.max(n, -2e4), _i), i = !f;
		if (f = n < Infinity && n > -Infinity && (i || r !== l || r !== _i && r !== -2e4), !f || i) {
			if (p && Si(c, l), p = !1, !f) continue;
			U[W++] = bi;
		}
		if (p && t > c) {
			let e = t - o, n = r - s;
			if (n >= u * e && n <= d * e) {
				n - H > u * e && (u = (n - H) / e), n + H < d * e && (d = (n + H) / e), c = t, l = r;
				continue;
			}
		}
		p && Si(c, l), p = !i && t > c, p ? (o = c, s = l, u = (r - H - s) / (t - o), d = (r + H - s) / (t - o)) : Si(t, r), c = t, l = r;
	}
	p && Si(c, l);
}
var wi = 16, G = new Uint8Array(wi * 1536), Ti = new TextDecoder(), [K, Ei, Di, Oi, ki] = [
	48,
	45,
	32,
	77,
	108
];
function Ai(e, t) {
	let n = e, r = t;
	if (n < 0 && (G[r++] = Ei, n = -n), n >= 1e4) {
		let e = n / 1e4 | 0;
		r = Ai(e, r), n -= e * 1e4, G[r++] = K + (n / 1e3 | 0), G[r++] = K + (n / 100 | 0) % 10, G[r++] = K + (n / 10 | 0) % 10;
	} else n >= 10 && (n >= 100 && (n >= 1e3 && (G[r++] = K + (n / 1e3 | 0)), G[r++] = K + (n / 100 | 0) % 10), G[r++] = K + (n / 10 | 0) % 10);
	return G[r] = K + n % 10, r + 1;
}
function ji() {
	G.length < wi * W && (G = new Uint8Array(32 * W));
	let e = 0, t = -1, n = 0, r = 0;
	for (let i = 0; i < W; i += 2) {
		U[i] === bi && (t = -1, i++);
		let a = U[i], o = U[i + 1], s = t < 0 ? a : a - n, c = t < 0 ? o : o - r;
		t < 1 ? G[e++] = t < 0 ? Oi : ki : s >= 0 && (G[e++] = Di), e = Ai(s, e), c >= 0 && (G[e++] = Di), e = Ai(c, e), t++, n = a, r = o;
	}
	return Ti.decode(G.subarray(0, e));
}
function Mi(e, t, n, r) {
	for (let i = 0; i < e.length; i++) {
		let a = e[i] * r;
		if (a < t || a > n) return !1;
	}
	return !0;
}
function Ni({ x: e, y: t }, n, r, i = 1, a = 12) {
	let o = [];
	if (Mi(t, n, r, i)) return o;
	let s = null, c = null;
	for (let l = 0; l < t.length && o.length < a; l++) {
		let a = t[l] * i;
		if (!Number.isFinite(a)) continue;
		let u = a >= n && a <= r;
		if (u !== s) {
			let t = {
				x: e[l],
				up: a > r
			};
			s === null && !u ? c = t : s && !u ? o.push(t) : c && u && (o.push({
				x: t.x,
				up: c.up
			}), c = null);
		}
		s = u;
	}
	return c ? [c] : o;
}
function Pi({ x: e, y: t }) {
	let n = [], r = -1;
	for (let i = 0; i <= t.length; i++) {
		let a = i < t.length && Number.isNaN(t[i]);
		a && r < 0 && (r = i), !a && r >= 0 && (n.push([e[r], e[Math.min(i, t.length - 1)]]), r = -1);
	}
	return n;
}
function Fi(e) {
	let t = Infinity, n = -Infinity;
	for (let r = 0; r < e.length; r++) {
		let i = e[r];
		Number.isFinite(i) && (i < t && (t = i), i > n && (n = i));
	}
	return [t, n];
}
// node_modules/lit-html/directives/guard.js
var Ii = {}, Li = Ce(class extends we {
	constructor() {
		super(...arguments), this.ot = Ii;
	}
	render(e, t) {
		return t();
	}
	update(e, [t, n]) {
		if (Array.isArray(t)) {
			if (Array.isArray(this.ot) && this.ot.length === t.length && t.every((e, t) => e === this.ot[t])) return v;
		} else if (this.ot === t) return v;
		return this.ot = Array.isArray(t) ? Array.from(t) : t, this.render(t, n);
	}
}), Ri = (e) => Math.round(e) + .5;
function zi({ sx: e, sy: t, xs: n, ys: r, width: i, height: a }) {
	return _`${n.map((t) => _`<path class="grid-line" d="M${Ri(e(t.value))} 0V${a}"/>`)}
    ${r.map((e) => _`<path class=${e.value === 0 ? "zero-line" : "grid-line"} d="M0 ${Ri(t(e.value))}H${i}"/>`)}`;
}
function Bi({ sx: e, sy: t, xs: n, ys: r, xLabels: i, width: a, height: o, rem: s }) {
	let c = .875 * s;
	return _`${r.map((e) => {
		let n = Math.min(t(e.value) + .35 * c, o + .1 * c);
		return _`<text class="tick" x=${-.5 * s} y=${n.toFixed(1)} text-anchor="end">${Ve(e.text)}</text>`;
	})}
  ${n.map((t) => {
		let n = e(t.value), r = n > a - .5 * s;
		return _`<text class="tick ${i ? "" : "own"}" x=${(r ? a : n).toFixed(1)} y=${(o + .5 * s + .8 * c).toFixed(1)} text-anchor=${r ? "end" : "middle"}>${Ve(t.text)}</text>`;
	})}`;
}
function Vi(e, { sx: t, sy: n, height: r, rem: i }) {
	let a = Math.min(n.low, n.high), o = Math.max(n.low, n.high), s = 1e-6 * (a > 0 ? a : o - a), c = .3125 * i, l = .4375 * i;
	return _`${Ni(e, a - s, o + s, e.factor ?? 1).map(({ x: n, up: i }) => {
		let a = t(n).toFixed(1), o = i ? `M${a} ${-l - 1}l${c} ${l}h${-2 * c}z` : `M${a} ${r + l + 1}l${c} ${-l}h${-2 * c}z`;
		return _`<path class="leaving" fill=${Kr(e.clothes)} d=${o}/>`;
	})}`;
}
function Hi({ x: e, y: t, text: n, anchor: r = "middle", ink: i, alarm: a }) {
	return _`<text class="label ${i ? "ink" : ""} ${a ? "alarm" : ""}" x=${e.toFixed(1)} y=${t.toFixed(1)} text-anchor=${r}>${Ve(n)}</text>`;
}
function Ui(e) {
	let { width: t, height: n, sx: r, sy: i, lines: a, rem: o } = e;
	return _`
    <svg width=${t} height=${n} class="clip">
      ${zi(e)}
      ${e.under ?? y}
      ${(e.hatched ?? []).map(([e, t]) => _`<rect class="hatched" fill="url(#hatch)" x=${r(e).toFixed(1)} y="0" width=${(r(t) - r(e)).toFixed(1)} height=${n}/>`)}
      ${(e.levels ?? []).map((e) => _`<path class="level" d="M0 ${Ri(i(e))}H${t}"/>`)}
      ${(e.verticals ?? []).map(({ x: e }) => _`<path class="period-line" d="M${Ri(r(e))} 0V${n}"/>`)}
      <g transform="scale(0.1)">${a.map((e) => _`<path class="c ${e.clothes} ${e.faded ? "faded" : ""} ${e.thick ? "thick" : ""}" d=${gi(e, r, i, e.factor)}/>`)}</g>
    </svg>
    ${a.map((t) => Vi(t, e))}
    ${(e.verticals ?? []).map(({ x: e, text: n }) => r(e) < t - 1.5 * o ? Hi({
		x: r(e) + .25 * o,
		y: .9 * o,
		text: n,
		anchor: "start"
	}) : y)}
    ${(typeof e.labels == "function" ? e.labels() : e.labels ?? []).map(Hi)}
    ${(e.rings ?? []).map(({ x: e, y: t }) => _`<circle class="ring" cx=${r(e).toFixed(1)} cy=${i(t).toFixed(1)} r=${.5 * o}/>`)}
    ${Bi(e)}`;
}
function Wi(e, t) {
	let { width: n, height: r, sx: i, sy: a, now: o, rem: s } = e, c = o === void 0 ? 0 : i(o), l = o !== void 0 && c >= -.5 && c <= n + .5;
	return _`<svg class="plot-drawing" width=${n} height=${r} viewBox="0 0 ${n} ${r}" aria-hidden="true">
    ${Li([
		...t,
		n,
		r,
		s
	], () => Ui(e))}
    ${l ? _`<path class="now-line" d="M${c.toFixed(1)} 0V${r}"/>
      ${(e.dots ?? []).map(({ clothes: e, y: t }) => {
		let n = a(t);
		return n >= -1 && n <= r + 1 ? _`<circle class="dot" cx=${c.toFixed(1)} cy=${n.toFixed(1)} r=${.3125 * s} fill=${Kr(e)}/>` : y;
	})}` : y}
  </svg>`;
}
function Gi(e) {
	let t = e.flatMap(Pi).sort((e, t) => e[0] - t[0]), n = [];
	for (let [e, r] of t) {
		let t = n.at(-1);
		t && e <= t[1] ? t[1] = Math.max(t[1], r) : n.push([e, r]);
	}
	return n;
}
// src/draw/scale.ts
function Ki(e, t) {
	let [n, r] = e, [i, a] = t, o = (a - i) / (r - n);
	return Object.assign((e) => i + o * (e - n), {
		invert: (e) => n + (e - i) / o,
		fill: (e, t, r) => {
			for (let a = 0; a < t.length; a++) e[a] = i + o * (t[a] * r - n);
		},
		low: n,
		high: r,
		key: `linear ${n} ${r} ${i} ${a}`
	});
}
var qi = 1e-9;
function Ji(e, t, n) {
	return Math.max(0, Math.floor(n / e + qi) - Math.ceil(t / e - qi) + 1);
}
function Yi(e, t, n) {
	let r = Math.ceil(t / e - qi);
	return Array.from({ length: Ji(e, t, n) }, (t, n) => Number(((r + n) * e).toPrecision(12)));
}
function Xi(e, t, n) {
	if (!(t > e)) return [e];
	let r = 10 ** Math.floor(Math.log10((t - e) / n));
	for (;;) {
		for (let i of [
			1,
			2,
			5
		]) if (Ji(i * r, e, t) <= n) return Yi(i * r, e, t);
		r *= 10;
	}
}
function Zi(e, t, n) {
	let r = [
		.01,
		.02,
		.05,
		.1,
		.2,
		.5,
		1,
		2,
		5,
		10,
		15,
		30,
		45,
		90,
		180,
		360
	];
	for (let e = 720; r.length < 40; e *= 2) r.push(e);
	return Yi(r.find((r) => Ji(r, e, t) <= n) ?? t - e, e, t);
}
function Qi(e) {
	let t = (e) => String(Number(e.toPrecision(12)));
	return Math.max(0, ...e.map((e) => t(e).split("e")[0]?.split(".")[1]?.length ?? 0));
}
// src/views/axis-ticks.ts
function $i(e, t, n = "") {
	let r = Qi(t);
	return t.map((t) => ({
		value: t,
		text: `${e.fixed(t, r)}${n}`
	}));
}
function ea(e, t, n, r) {
	return $i(e, Xi(t, n, r));
}
function ta({ words: e, session: t, store: n }, { key: r, name: i, items: a, className: o = "" }) {
	let { save: s, loadingView: c, failedView: l } = e.say.plots, u = `save-${r}`, d = t.menu === u, f = [{
		text: c,
		disabled: !0,
		act: () => {}
	}];
	return pi({
		key: u,
		label: S("save"),
		name: e.fill(s, { plot: i }),
		open: d,
		toggle: (e) => n.setSession({ menu: e ? u : null }),
		items: d ? f : [],
		className: `save right ${o}`
	});
}
// package.json
var na = "0.1.0", ra = (e) => e === "," ? ";" : ",", ia = (e) => /[",;]/.test(e) ? `"${e.replaceAll("\"", "\"\"")}"` : e, aa = ({ title: e, about: t }) => t === void 0 ? [] : [`# ${w(e)}: ${w(t)}`];
function oa(e, { caption: t, first: n, columns: r }, i, a = e.decimal) {
	let o = ra(a), s = (e) => Number.isFinite(e) ? String(e).replace(".", a) : "", c = [n, ...r], l = Array.from(n.values, (e, t) => c.map(({ values: e, factor: n }) => s(e[t] * n)).join(o));
	return [
		`# ${w(t)}`,
		`# ${i}`,
		`# libration ${na}; ${e.say.table[a === "," ? "decimalComma" : "decimalPoint"]}`,
		...c.flatMap(aa),
		c.map(({ title: e }) => ia(w(e))).join(o),
		...l,
		""
	].join("\r\n");
}
// src/save/file.ts
function sa(e, t, n) {
	let r = URL.createObjectURL(new Blob([...e], { type: t })), i = document.createElement("a");
	i.href = r, i.download = n, i.click(), setTimeout(() => URL.revokeObjectURL(r), 6e4);
}
// src/views/table.ts
var ca = 8;
function la({ store: e }) {
	return location.href.replace(/#.*$/, "") + yn(e.moment, e.kept);
}
function ua(e, t, n) {
	sa(["﻿", oa(e.words, t, la(e), n)], "text/csv;charset=utf-8", `${t.file}.csv`);
}
function da(e, t, n) {
	let { words: r, store: i, session: a } = e, { first: o, columns: s } = n, c = o.values.length, l = a.wholeTables.includes(t), u = l ? 1 : Math.max(1, Math.floor((c - 1) / ca)), d = Array.from({ length: Math.floor((c - 1) / u) + 1 }, (e, t) => t * u), f = l ? d : n.some ?? d, p = ({ values: e, factor: t, decimals: n, digits: i }, a) => {
		let o = e[a] * t;
		return Number.isNaN(o) ? r.say.table.noValue : i === void 0 ? r.fixed(o, n) : r.significant(o, i);
	};
	return g`<div class="table-box" tabindex="0" role="region" aria-label=${w(n.caption)}><table class="data">
    <caption>${C(n.caption)} <button type="button" class="text-button" @click=${() => ua(e, n)}>${r.say.table.csv}</button> ·
      <button type="button" class="text-button" @click=${() => i.setSession({ wholeTables: l ? a.wholeTables.filter((e) => e !== t) : [...a.wholeTables, t] })}>${l ? r.say.table.some : r.fill(r.say.table.all, { count: c })}</button></caption>
    <thead><tr><th scope="col">${C(o.title)}</th>${s.map(({ title: e }) => g`<th scope="col">${C(e)}</th>`)}</tr></thead>
    <tbody>${f.map((e) => g`<tr><th scope="row">${p(o, e)}</th>${s.map((t) => g`<td>${C(p(t, e))}</td>`)}</tr>`)}</tbody>
  </table></div>`;
}
var fa = 130.8, pa = 2.5, ma = 400;
function ha({ values: e, low: t, high: n }, r = ma) {
	let i = n > t ? n - t : 1;
	return Float64Array.from({ length: r + 1 }, (n, a) => {
		let o = (e[Math.round(a * (e.length - 1) / r)] - t) / i;
		return fa * 2 ** (pa * Math.min(1, Math.max(0, o)));
	});
}
function ga(e, t, n) {
	let r = ha(t), i = e.createOscillator(), a = e.createOscillator();
	i.type = "sine", a.type = "sawtooth";
	let o = e.createGain(), s = e.createGain(), c = e.createStereoPanner();
	o.gain.setValueAtTime(0, n), s.gain.setValueAtTime(0, n), i.connect(o).connect(c), a.connect(s).connect(c), c.connect(e.destination), c.pan.setValueAtTime(-1, n), c.pan.linearRampToValueAtTime(1, n + 4);
	let { values: l } = t;
	r.forEach((e, t) => {
		let c = n + 4 * t / (r.length - 1), u = l[Math.round(t * (l.length - 1) / (r.length - 1))], d = Number.isFinite(e);
		d && (i.frequency.linearRampToValueAtTime(e, c), a.frequency.linearRampToValueAtTime(e, c)), o.gain.linearRampToValueAtTime(d ? .18 : 0, c), s.gain.linearRampToValueAtTime(d && u < 0 ? .035 : 0, c);
	});
	let u = n + 4;
	o.gain.linearRampToValueAtTime(0, u + .05), s.gain.linearRampToValueAtTime(0, u + .05);
	for (let e of [i, a]) e.start(n), e.stop(u + .1);
	return [i, a];
}
function _a(e, t) {
	let n = new AudioContext(), [r] = ga(n, e, n.currentTime + .05), i = () => {
		n.state !== "closed" && n.close();
	};
	return r?.addEventListener("ended", () => {
		i(), t();
	}), i;
}
// src/views/trace.ts
var va = null;
function ya(e, t, n) {
	let r = e.session.sounding;
	va?.(), va = null, r === t || !n ? e.setSession({ sounding: null }) : (va = _a(n(), () => e.setSession({ sounding: null })), e.setSession({ sounding: t }));
}
// src/views/chart.ts
function ba(e, t) {
	return typeof t == "string" ? w(t) : e.session.held === null ? w(t()) : v;
}
function xa(e, t) {
	let { store: n, session: r, words: i } = e, { plots: a } = i.say, o = r.tables.includes(t.key), s = r.sounding === t.key;
	return g`<span class="tools">${t.switches ?? y}
    ${t.table ? fi(i.fill(a.table, { plot: t.name }), "table", () => Sa(e, t.key), o) : y}
    ${t.sound ? fi(i.fill(s ? a.stop : a.listen, { plot: t.name }), "sound", () => ya(n, t.key, t.sound), s) : y}${t.table ? ta(e, {
		key: t.key,
		name: t.name,
		items: (n) => n.chartItems(e, t)
	}) : y}</span>`;
}
function Sa({ store: e, session: t }, n) {
	let r = t.tables.includes(n);
	e.setSession({ tables: r ? t.tables.filter((e) => e !== n) : [...t.tables, n] });
}
function Ca(e, { name: t, spoken: n }, { from: r, to: i }) {
	let { store: a, t: o, words: s } = e, c = (e) => {
		a.clock.pause(), a.seek(Math.min(Math.max(e, 0), i - 1e-6 * (i - r)));
	}, { playing: l } = a.clock;
	return {
		label: s.fill(s.say.plots.now, { plot: t }),
		least: r,
		most: i,
		now: l ? r : Number(o.toFixed(3)),
		text: l || n === void 0 ? null : ba(e, n),
		key: (e) => {
			let t = We(e, {
				value: a.clock.t,
				least: r,
				most: i,
				step: (i - r) / 100
			});
			return t !== null && c(t), t !== null;
		},
		drag: { at: (e, t, n) => c(r + (i - r) * Ke(e, n)) }
	};
}
function wa(e, t) {
	let { rem: n } = e, r = Fe(t.key), i = r && r.width > 0 ? t.draw({
		width: r.width,
		height: r.height,
		rem: n
	}) : y, a = `--plot-height:${t.height}rem`, o = `plot ${t.xLabels ? "with-x" : "without-x"}`, s = t.cursor ?? (t.window && Ca(e, t, t.window));
	return !s || t.waiting ? g`<div class=${o} style=${a} ${Ie(t.key)}>${i}${t.waiting ? g`<p class="waiting">${t.waiting}</p>` : y}${t.over ?? y}</div>` : g`<div class=${o} style=${a} ${Ie(t.key)} role="slider" tabindex="0" data-plot=${t.key}
    aria-label=${s.label} aria-valuemin=${s.least} aria-valuemax=${s.most}
    aria-valuenow=${s.now} aria-valuetext=${s.text ?? y}
    @keydown=${(e) => {
		s.key(e) && (e.preventDefault(), e.stopPropagation());
	}}
    @pointerdown=${Ge(s.drag)}>${i}${t.over ?? y}</div>`;
}
function Ta(e, t) {
	let n = e.session.tables.includes(t.key) && t.table;
	return g`<figure class="chart ${t.className}" data-chart=${t.key} aria-label=${w(t.title)}>
    <div class="head"><h2>${C(t.title)}${t.unit ? g` <span class="unit">${C(t.unit)}</span>` : y}</h2>${xa(e, t)}</div>
    ${wa(e, t)}
    ${t.note ?? y}
    ${n && t.table ? da(e, t.key, t.table()) : y}
    <figcaption class="unseen">${ba(e, t.caption)}</figcaption>
  </figure>`;
}
// src/views/compare.ts
function Ea({ words: e }, t) {
	let { name: n } = e.say.curves[t.name];
	if (t.argument === void 0) return w(n);
	let { argument: r } = A(t.name), i = w(n).replace(/ N$/, "");
	return r?.of === "order" ? `${i} ${t.argument}` : `${i} ${e.with(e.given(t.argument), e.say.units.s)}`;
}
function Da(e, t) {
	let { compare: n, curves: r } = e.words.say;
	if (!t) return {
		title: n.exact,
		clothes: "c-exact",
		about: n.exactBy
	};
	let { curve: i, clothes: a } = t;
	return {
		title: Ea(e, i),
		clothes: a,
		about: e.words.formula(r[i.name].what)
	};
}
// src/views/time-axis.ts
function Oa({ from: e, to: t }, { width: n }) {
	return Ki([e, t], [0, n]);
}
function ka(e, { from: t, to: n }, { width: r, rem: i }) {
	let a = r < 24 * i ? 5 : 9, o = n - t, s = 3.2 * i * o / r, c = Xi(t, n, a), l = Math.abs((c.at(-1) ?? t) - n) < 1e-9 * o, u = l ? c : [...c.filter((e) => n - e > s), n], d = Qi(l ? u : u.slice(0, -1));
	return u.map((t, n) => {
		let r = n === u.length - 1, i = e.fixed(t, r && !l ? Math.max(d, 2) : d);
		return {
			value: t,
			text: r ? e.with(i, e.say.units.s) : i
		};
	});
}
function Aa({ words: e, state: t }, { motion: n }, r) {
	return (t.hide ? [] : r).map((t) => {
		let r = Math.round(t / n.period);
		return {
			x: t,
			text: r === 1 ? "_T_" : `${e.given(r)}_T_`
		};
	});
}
function ja(e, t) {
	return e.with(e.given(Number(t.toFixed(2))), e.say.units.s);
}
function Ma({ motion: e, window: t }) {
	let { period: n } = e;
	if (!(n > 0) || !Number.isFinite(n) || (t.to - t.from) / n > 12) return [];
	let r = Math.max(1, Math.ceil(t.from / n + 1e-9)), i = [];
	for (let e = r; e * n <= t.to * (1 + 1e-12); e++) i.push(e * n);
	return i;
}
// src/views/angle.ts
function Na(e, t, n, r) {
	let [i, a] = Fi(e), o = 3 * Math.max(a - i, r / n), s = {
		low: i,
		high: a
	};
	for (let e of t) {
		let [t, n] = Fi(e);
		t < i && (i = Math.max(t, s.low - o)), n > a && (a = Math.min(n, s.high + o));
	}
	let c = .06 * Math.max(a - i, r / n);
	return [(i - c) * n, (a + c) * n];
}
var Pa = {
	angle: {
		of: ({ track: e }) => e.theta,
		factor: rt
	},
	velocity: {
		of: ({ track: e }) => e.velocity,
		factor: 1
	}
};
function Fa(e, t) {
	let { of: n, factor: r } = Pa[t], i = t === "angle" ? e.exact.theta : e.exact.velocity, a = e.shown.filter(({ curve: e }) => ![
		"taylor",
		"small-m",
		"cubic"
	].includes(e.name)).map(n), { regime: o } = e.motion;
	if (o === "rest" && t === "angle") return e.motion.balanced ? [-190, 190] : [-16, 16];
	let [s, c] = Na(i, a, r, o === "rest" ? 2 : 1e-6);
	if (t === "angle" && s > -191 && c < 191 && c - s > 200) return [-190, 190];
	if (t === "angle" && s > -191 && c < 191 && s < 0 && c > 0) {
		let e = Math.max(-s, c);
		return [-e, e];
	}
	return [s, c];
}
var Ia = L(Fa), q = null;
function La(e, t) {
	let { session: n, state: r } = e, i = Ia(t, r.quantity);
	if (n.held !== null && n.held !== "time") {
		q ??= i;
		let e = r.quantity === "angle" && q[1] < 190 ? [Math.min(q[0], -190), Math.max(q[1], 190)] : q;
		return n.held === "bob" ? e : q;
	}
	return q = null, i;
}
function Ra(e, [t, n], { height: r, rem: i }) {
	let { words: a, state: o } = e, s = Math.min(7, Math.max(2, Math.floor(r / (1.6 * i))));
	return o.quantity === "angle" ? Zi(t, n, s).map((e) => ({
		value: e,
		text: `${a.typed(e)}°`
	})) : ea(a, t, n, s);
}
function za(e, t) {
	let { words: n, model: r } = e;
	return t.shown.filter(({ gone: e }) => !Number.isNaN(e)).map(({ curve: t }) => {
		let i = Ea(e, t), { reasons: a } = n.say, o = a[t.name] ?? a.none, s = t.name === "fourier" ? n.angle(r.undefinedAbove(t), 2) : "";
		return n.formula(n.fill(o, {
			name: i,
			angle: s
		}));
	});
}
function Ba(e, t) {
	let n = za(e, t);
	return n.length === 0 ? y : g`<p class="plot-note">${C(e.words.fill(e.words.say.plots.hatched, { reasons: n.join(" ") }))}</p>`;
}
function Va({ motion: e, shown: t, window: n }) {
	return e.regime === "libration" ? t.flatMap((e) => {
		let t = e.solution.overTop;
		return t >= n.from && t <= n.to ? [{
			drawn: e,
			t
		}] : [];
	}) : [];
}
function Ha(e, t) {
	let { words: n } = e;
	return Va(t).map(({ drawn: t, t: r }) => {
		let i = Ea(e, t.curve);
		return `${n.fill(n.say.alarms.overTop, {
			name: i,
			t: ja(n, r)
		})}.`;
	}).join(" ");
}
function Ua(e, t) {
	let { quantity: n } = e.state, { of: r, factor: i } = Pa[n], a = e.session.pointed, o = t.times, s = {
		x: o,
		y: n === "angle" ? t.exact.theta : t.exact.velocity,
		clothes: "c-exact",
		factor: i,
		faded: a !== null
	}, c = t.shown.map((e) => ({
		x: o,
		y: r(e),
		clothes: e.clothes,
		factor: i,
		faded: a !== null && a !== e.key
	}));
	return [
		...c.filter(({ clothes: e }) => !e.startsWith("c-fourier")),
		s,
		...c.filter(({ clothes: e }) => e.startsWith("c-fourier"))
	];
}
function Wa(e, t, n) {
	let { words: r, state: i, t: a } = e, { width: o, height: s } = n, c = La(e, t), l = Oa(t.window, n), u = Ki(c, [s, 0]), { quantity: d } = i, { factor: f } = Pa[d], p = (e) => (d === "angle" ? e.solution.theta(a) : e.solution.velocity(a)) * f, m = (d === "angle" ? t.motion.theta(a) : t.motion.velocity(a)) * f, ee = d === "angle" ? Va(t) : [], te = ee.map(({ drawn: e, t }) => ({
		x: t,
		y: e.solution.theta(t) * f
	})), h = ee.map(({ drawn: t, t: i }, a) => {
		let c = Ea(e, t.curve), d = r.with(r.fixed(i, 2), r.say.units.s), f = l(i) > o / 2, p = u(te[a]?.y ?? 0), m = p + 1.5 * n.rem < s;
		return {
			x: l(i) + (f ? -.5 : .5) * n.rem,
			y: m ? p + 1.4 * n.rem : p - .8 * n.rem,
			text: `*${r.fill(r.say.alarms.overTop, {
				name: c,
				t: d
			})}*`,
			alarm: !0,
			anchor: f ? "end" : "start"
		};
	});
	return Wi({
		...n,
		sx: l,
		sy: u,
		xs: ka(r, t.window, n),
		ys: Ra(e, c, n),
		xLabels: !1,
		lines: Ua(e, t),
		hatched: Gi(t.shown.map((e) => ({
			x: t.times,
			y: e.track.theta
		}))),
		verticals: Aa(e, t, Ma(t)),
		rings: te,
		labels: h,
		now: a,
		dots: [...t.shown.map((e) => ({
			clothes: e.clothes,
			y: p(e)
		})), {
			clothes: "c-exact",
			y: m
		}]
	}, [
		t,
		d,
		u.key,
		r,
		e.session.pointed
	]);
}
function Ga(e, t) {
	let { words: n, state: r } = e, { of: i, factor: a } = Pa[r.quantity], o = r.quantity === "angle", s = n.say.plots, c = o ? "°" : n.say.units["rad/s"], l = o ? 2 : 3;
	return {
		caption: n.fill(n.say.table.caption, {
			plot: o ? s.angle : s.velocity,
			unit: c
		}),
		file: o ? "angle" : "velocity",
		first: {
			title: n.say.table.time,
			values: t.times,
			factor: 1,
			decimals: 3
		},
		columns: [{
			...Da(e),
			values: o ? t.exact.theta : t.exact.velocity,
			factor: a,
			decimals: l
		}, ...t.shown.map((t) => ({
			...Da(e, t),
			values: i(t),
			factor: a,
			decimals: l
		}))]
	};
}
function Ka(e, t) {
	let { words: n, state: r, t: i } = e, a = r.quantity === "angle", o = (e) => a ? n.angle(e, 1) : n.with(n.fixed(e, 2), n.say.units["rad/s"]), s = a ? t.motion.theta(i) : t.motion.velocity(i), c = t.shown.map(({ curve: t, solution: r }) => {
		let s = a ? r.theta(i) : r.velocity(i);
		return `${Ea(e, t)} ${Number.isNaN(s) ? n.say.table.noValue : o(s)}`;
	});
	return [
		ja(n, i),
		`${n.say.compare.exact} ${o(s)}`,
		...c
	].join(", ");
}
function qa(e, t) {
	let { words: n, state: r, store: i } = e, { plots: a } = n.say, o = r.quantity === "angle", s = o ? t.exact.theta : t.exact.velocity, [c, l] = Fi(s), u = (e) => o ? n.angle(e, 1) : n.with(n.fixed(e, 2), n.say.units["rad/s"]), d = () => n.fill(o ? a.captionAngle : a.captionVelocity, {
		from: ja(n, t.window.from),
		to: ja(n, t.window.to),
		least: u(c),
		most: u(l)
	});
	return Ta(e, {
		key: "angle",
		className: "first-chart",
		title: o ? a.angleTitle : a.velocityTitle,
		...o ? {} : { unit: a.velocityUnit },
		name: w(o ? a.angle : a.velocity),
		height: 12.5,
		xLabels: !1,
		switches: di(a.shows, [{
			value: "angle",
			text: a.angle
		}, {
			value: "velocity",
			text: a.velocity
		}], r.quantity, (e) => i.set({ quantity: e })),
		draw: (n) => Wa(e, t, n),
		caption: () => `${d()} ${Ha(e, t)}`.trim(),
		spoken: () => Ka(e, t),
		window: t.window,
		table: () => Ga(e, t),
		sound: () => ({
			values: s,
			low: c,
			high: l
		}),
		note: Ba(e, t)
	});
}
// src/draw/pendulum.ts
var Ja = {
	width: 280,
	height: 246
}, J = {
	x: 128,
	y: 127
}, Y = 92, X = {
	x: 268,
	width: 12
}, Z = J.y + Y, Ya = J.y - Y;
function Q(e, t = Y) {
	return {
		x: J.x + t * Math.sin(e),
		y: J.y + t * Math.cos(e)
	};
}
function Xa(e, t) {
	return Math.atan2(e - J.x, t - J.y);
}
var $ = (e) => e.toFixed(1);
function Za(e, t, n) {
	let r = Q(e, n), i = Q(t, n), a = +(Math.abs(t - e) > Math.PI);
	return `M${$(r.x)} ${$(r.y)}A${n} ${n} 0 ${a} ${+(t < e)} ${$(i.x)} ${$(i.y)}`;
}
var Qa = Array.from({ length: 36 }, (e, t) => {
	let n = t * 10 - 170, r = Q(n * Math.PI / 180, 95), i = Q(n * Math.PI / 180, Y + (n % 30 == 0 ? 9 : 6));
	return `M${$(r.x)} ${$(r.y)}L${$(i.x)} ${$(i.y)}`;
}).join(""), $a = [
	[
		0,
		1,
		12,
		"middle"
	],
	[
		90,
		3,
		5,
		"start"
	],
	[
		-90,
		-3,
		5,
		"end"
	],
	[
		180,
		1,
		-3,
		"middle"
	]
];
function eo({ kinetic: e, potential: t, words: n }) {
	let r = e + t, i = Z - 184 * Math.min(r, 1), a = Z - 184 * Math.min(t, 1), o = X.x + X.width, s = r > 1.0005, c = Math.max(i, Ya) + 16, l = c > J.y - 52 && c < J.y + 52 ? J.y + 56 : c, u = a - 4 > l && a - i > 18;
	return _`
    <rect class="column" x=${X.x} y=${Ya} width=${X.width} height=${184}/>
    <rect class="potential" x=${X.x} y=${$(a)} width=${X.width} height=${$(Z - a)}/>
    <rect class="kinetic" x=${X.x} y=${$(i)} width=${X.width} height=${$(Math.max(a - i, 0))}/>
    ${s ? _`<path class="kinetic" d="M${X.x} ${Ya - 1}h${X.width}l${-X.width / 2} -7z"/>` : y}
    ${u ? _`<text x=${X.x - 5} y=${$(l)} text-anchor="end">${n.kinetic}</text>` : y}
    ${Z - a > 18 ? _`<text x=${X.x - 5} y=${Z - 4} text-anchor="end">${n.potential}</text>` : y}
    <text x=${o} y=${Ya - (s ? 14 : 6)} text-anchor="end">${s ? n.more : n.energy}</text>`;
}
function to(e) {
	let { angle: t, release: n, reach: r, ghosts: i } = e, a = r < Math.PI, o = Q(t), s = Q(n), c = Z - 184 * Math.min(e.kinetic + e.potential, 1), l = t - 2 * Math.PI * Math.round(t / (2 * Math.PI)), u = Q(l / 2, 42), d = Math.abs(l) > .12;
	return _`
    <circle class="grid-line" cx=${J.x} cy=${J.y} r=${Y}/>
    <path class="zero-line" d=${Qa}/>
    ${$a.map(([t, n, r, i]) => {
		let a = Q(t * Math.PI / 180, 102);
		return _`<text x=${$(a.x + n)} y=${$(a.y + r)} text-anchor=${i}>${e.degree(t)}</text>`;
	})}
    ${a ? _`<path class="reach" d=${Za(-r, r, Y)}/>` : _`<circle class="reach" cx=${J.x} cy=${J.y} r=${Y}/>`}
    <path class="plumb" d="M${J.x} ${J.y}V${Z}"/>
    ${d ? _`<path class="angle-arc" d=${Za(0, l, 30)}/><text visibility=${Math.abs(l) > .4 ? "visible" : "hidden"} class="symbol" x=${$(u.x)} y=${$(u.y + 5)} text-anchor="middle">θ</text>` : y}
    ${a && r > .02 ? _`<path class="level" d="M${$(s.x)} ${$(c)}H${X.x + X.width}"/>` : y}
    ${eo(e)}
    ${i.map(({ clothes: e, angle: t, faded: n }) => {
		if (!Number.isFinite(t)) return y;
		let r = Q(t);
		return _`<g class=${n ? "faded" : ""}><path class="c thin ${e}" d="M${J.x} ${J.y}L${$(r.x)} ${$(r.y)}"/>
        <circle class="ghost" cx=${$(r.x)} cy=${$(r.y)} r="6" stroke=${Kr(e)}/></g>`;
	})}
    <circle class="release" cx=${$(s.x)} cy=${$(s.y)} r="10"/>
    <path class="rod" d="M${J.x} ${J.y}L${$(o.x)} ${$(o.y)}"/>
    <circle class="pivot" cx=${J.x} cy=${J.y} r="3.5"/>`;
}
// src/views/page.ts
function no(e, t, n) {
	let { unit: r } = M[t];
	return r === "deg" ? e.angle(n) : r === "" ? e.given(n) : e.with(e.given(n), e.say.units[r]);
}
function ro(e, t, n) {
	return N(t, n) ? (e.set({ [t]: n }), !0) : !1;
}
// src/views/values.ts
var io = [
	1.62,
	3.71,
	9.81,
	24.79
];
function ao(e, t) {
	switch (t) {
		case "theta0": return {
			least: -180,
			most: 180,
			step: 1,
			grain: 1,
			origin: 0,
			ticks: [
				-180,
				-90,
				0,
				90,
				180
			]
		};
		case "velocity0": {
			let t = e.motion?.separatrixVelocity(e.state.theta0) ?? 0;
			return {
				least: -10,
				most: 10,
				step: .1,
				grain: .05,
				origin: 0,
				ticks: t > 0 && t < 10 && !e.state.hide ? [
					-t,
					0,
					t
				] : [0]
			};
		}
		case "length": return {
			least: .01,
			most: 2,
			step: .01,
			grain: .01,
			origin: 0,
			ticks: [.01, 1]
		};
		case "gravity": return {
			least: .01,
			most: 25,
			step: .01,
			grain: .01,
			origin: 0,
			ticks: io
		};
		default: return {
			least: 0,
			most: 1,
			step: 1,
			grain: 1,
			origin: 0,
			ticks: []
		};
	}
}
function oo(e, t) {
	return E(t, M[e].unit);
}
function so(e, t, n, r) {
	if (n === void 0 || n.trim() === "") return null;
	let { words: i, state: a } = e, o = oo(t, n);
	if (N(t, o)) return null;
	let s = M[t], c = r ?? i.say.values[t]?.label ?? t, l = t === "span" && a.span === "T" ? w(i.say.play.period) : no(i, t, Number(a[t])), u = s.unit === "deg" ? "°" : i.say.units[s.unit], d = Number.isNaN(o) ? n.trim() : i.with(n.trim().replace(/\s*(?!e[-+]?\d)[a-z°].*$/i, ""), u).replace(/\s°/, "°"), f = i.say.faults[Number.isNaN(o) ? "not-a-number" : "out-of-range"];
	return i.fill(f, {
		name: c,
		value: d,
		kept: l,
		least: no(i, t, s.least),
		most: no(i, t, s.most)
	});
}
function co({ words: e }, { label: t, symbol: n }) {
	let { embedding: r } = e.say;
	return g`<div class="value" data-value="hidden" title=${r.hiddenTitle}><span>${C(`${t} ${n}`)}</span><span class="field locked">${r.hidden}${S("lock")}</span></div>`;
}
function lo(e, t, n, r) {
	let { words: i, state: a, store: o, session: s } = e, { unit: c } = M[t], l = c === "deg", u = a[t], d = l ? O(u) : u, f = s.drafts[t], p = Rt(a, t);
	return {
		key: t,
		label: n.label,
		symbol: n.symbol,
		unit: l ? "°" : i.say.units[c],
		value: d,
		current: () => l ? O(o.state[t]) : o.state[t],
		...r,
		text: i.typed(d),
		spoken: no(i, t, u),
		draft: f,
		fault: so(e, t, f, n.label),
		...p ? {
			locked: p,
			title: i.say.embedding.locked
		} : {},
		onText: (e) => {
			o.draft(t, e), ro(o, t, oo(t, e));
		},
		onDone: () => so(e, t, f) === null && o.draft(t, null),
		onSlide: (e) => {
			o.draft(t, null), ro(o, t, l ? D(e) : e);
		},
		onHold: (e) => o.setSession({ held: e ? t : null })
	};
}
function uo(e, t, n, r) {
	return Ze(lo(e, t, n, r));
}
function fo(e, t) {
	let n = e.words.say.values[t];
	return e.state.hide && t === "gravity" ? co(e, n) : uo(e, t, n, ao(e, t));
}
// src/views/bench.ts
function po({ store: e }, t) {
	e.clock.pause(), e.draft("theta0", null), e.set({
		theta0: t,
		t: 0
	});
}
function mo(e, t) {
	let { store: n, state: r, words: i } = e, a = O(r.theta0), o = Q(t), s = r.theta0, c = Ge({
		at: (t, n, r) => {
			let i = r.ownerSVGElement;
			if (!i) return;
			let a = i.getBoundingClientRect(), o = Ja.width / a.width, s = Xa((t - a.left) * o, (n - a.top) * o);
			po(e, D(Math.round(O(s))));
		},
		begin: () => n.setSession({ held: "bob" }),
		end: (t) => {
			n.setSession({ held: null }), t ? po(e, s) : !n.session.reduced && !matchMedia("(prefers-reduced-motion: reduce)").matches && n.play();
		}
	}), l = (t) => {
		let r = We(t, {
			value: O(n.state.theta0),
			least: -180,
			most: 180,
			step: 1
		});
		r !== null && (t.preventDefault(), t.stopPropagation(), po(e, D(r)));
	}, u = Rt(r, "theta0");
	return g`<svg class="bob-drawing" viewBox="0 0 ${Ja.width} ${Ja.height}"><g class="bob-handle" role="slider" tabindex=${u ? -1 : 0} aria-disabled=${u ? "true" : y} aria-label=${i.say.drawing.bob} aria-valuemin="-180" aria-valuemax="180"
    aria-valuenow=${a} aria-valuetext=${i.fill(i.say.drawing.bobText, { angle: i.typed(a) })} data-exact=${String(t)} transform="translate(${o.x.toFixed(2)} ${o.y.toFixed(2)})"
    @pointerdown=${u ? y : c} @keydown=${u ? y : l}>${u ? _`<title>${i.say.embedding.locked}</title>` : y}<circle class="reach-target" r="16"/><circle class="bob" r="10"/></g></svg>`;
}
var ho = ({ state: e, words: t }, n) => e.hide ? "–" : t.with(t.fixed(100 * n, 0), "%");
function go(e, t, n, r) {
	let { motion: i, state: a, words: o } = e, { kinetic: s, potential: c } = i.energyAt(t, n), l = o.say.drawing;
	return {
		angle: t,
		release: a.theta0,
		reach: i.regime === "libration" ? i.thetaMax : i.regime === "rest" ? 0 : Math.PI,
		kinetic: s,
		potential: c,
		ghosts: r,
		words: {
			...l,
			more: o.fill(l.more, { percent: ho(e, s + c) })
		},
		degree: (e) => `${o.typed(e)}°`
	};
}
function _o(e, t) {
	let { motion: n, t: r, words: i } = e, a = n.theta(r), o = n.velocity(r), s = go(e, a, o, t), c = i.say.drawing, l = i.with(i.fixed(o, 2), i.say.units["rad/s"]), u = i.fill(c.caption, {
		t: i.with(i.fixed(r, 2), i.say.units.s),
		angle: i.angle(a, 1),
		velocity: l,
		kinetic: ho(e, s.kinetic),
		potential: ho(e, s.potential)
	});
	return g`<figure class="drawing" aria-label=${c.name}>
    <div class="drawing-box"><svg viewBox="0 0 ${Ja.width} ${Ja.height}" aria-hidden="true">${to(s)}</svg>${mo(e, a)}</div>
    <div class="reading reading-top" aria-hidden="true"><i>θ</i> = <b class="number">${i.angle(a, 1)}</b></div>
    <div class="reading reading-bottom" aria-hidden="true"><i class="dotted">θ</i> = <b class="number">${l}</b></div>
    ${ta(e, {
		key: "pendulum",
		name: c.name,
		items: (n) => n.pendulumItems(e, t),
		className: "in-corner"
	})}
    <figcaption class="unseen">${e.store.clock.playing ? y : u}</figcaption>
  </figure>`;
}
function vo(e) {
	let { motion: t, words: n, session: r, store: i, state: a } = e;
	if (a.hide) return y;
	let o = n.say.facts, { period: s, smallPeriod: c, regime: l } = t, u = (e, t = 4) => Number.isFinite(e) ? n.with(n.fixed(e, t), n.say.units.s) : o.infinite, d = l === "rest", f = l === "rotation", p = mi("parameter", o.parameter, n.formula(n.say.hints.parameter), r.hint === "parameter", (e) => i.setSession({ hint: e ? "parameter" : null }));
	return g`<dl class="facts">
    <dt class="big">${C(f ? o.turn : o.period)}</dt><dd class="big" id="period-value">${d ? o.none : u(s)}</dd>
    <dt>${C(o.smallPeriod)}</dt><dd>${u(c)}</dd>
    <dt>${C(o.ratio)}</dt><dd>${d || f ? o.none : Number.isFinite(s) ? n.fixed(s / c, 4) : "∞"}</dd>
    <dt>${p} ${C(n.formula(a.velocity0 === 0 ? o.parameterIs : o.energyIs))}</dt><dd>${n.fixed(t.energyRatio, 4)}</dd>
  </dl>`;
}
var yo = [
	"theta0",
	"velocity0",
	"length",
	"gravity"
];
function bo(e, t) {
	return g`<div class="column left ${yo.some((t) => so(e, t, e.session.drafts[t]) !== null) ? "faulty" : ""}">${_o(e, t)}
    <div class="first-values">${fo(e, "theta0")}</div>
    <div class="more-values">${fo(e, "velocity0")}${fo(e, "length")}${fo(e, "gravity")}</div>
    ${vo(e)}</div>`;
}
function xo({ motion: e, state: t, words: n }) {
	let r = n.say.sentence;
	if (t.hide) return n.say.embedding.sentence;
	let { regime: i, period: a, smallPeriod: o, thetaMax: s } = e, c = n.shortAngle(t.theta0), l = n.with(n.given(Number(t.velocity0.toPrecision(5))), n.say.units["rad/s"]), u = n.with(n.fixed(a, 3), n.say.units.s);
	if (i === "rest") return e.balanced ? r.balance : n.fill(r.rest, { angle: c });
	if (i === "separatrix") return n.fill(r.separatrix, {
		angle: c,
		velocity: l
	});
	if (i === "rotation") return n.fill(r.rotates, {
		angle: c,
		velocity: l,
		period: u
	});
	let d = 100 * (a / o - 1), f = n.with(d >= 1 ? n.fixed(d, 1) : n.significant(d, 2), "%");
	return t.velocity0 === 0 ? n.fill(r.swings, {
		angle: c,
		period: u,
		longer: f
	}) : n.fill(r.swingsThrown, {
		angle: c,
		velocity: l,
		top: n.angle(s, 1),
		period: u,
		longer: f
	});
}
// src/controls/play.ts
function So(e) {
	let { playing: t, t: n, from: r, to: i, names: a } = e, o = (e) => 100 * Math.min(Math.max(e - r, 0), i - r) / (i - r), s = o(n);
	return g`<div class="play" role="group" aria-label=${a.bar}>
    <button type="button" class="go" id="play" aria-label=${t ? a.pause : a.play} title=${t ? a.pause : a.play} @click=${e.onPlay}>${S(t ? "pause" : "play")}</button>
    <div class="scrub" @pointerdown=${Ge({
		at: (t, n, a) => e.onSeek(r + (i - r) * Ke(t, a)),
		begin: () => e.onHold(!0),
		end: () => e.onHold(!1)
	})}>
      <i class="fill" style="width:${s}%"></i>
      ${e.ticks.map((e) => g`<i class="notch" style="left:${o(e)}%"></i>`)}
      <b class="handle" role="slider" tabindex="0" aria-label=${a.bar} aria-valuemin=${r} aria-valuemax=${i} aria-valuenow=${t ? r : Number(n.toFixed(3))}
        aria-valuetext=${t ? y : e.spoken} style="left:${s}%"
        @keydown=${(t) => {
		let n = We(t, {
			value: e.current(),
			least: r,
			most: i,
			step: .1
		});
		n !== null && (t.preventDefault(), t.stopPropagation(), e.onSeek(n));
	}}></b>
    </div>
    <div class="short">${e.field("short")}</div>
    <div class="options"><span class="steps">${e.field("bar")}${fi(a.back, "back", () => e.onStep(-1))}${fi(a.on, "step", () => e.onStep(1))}</span>
      ${e.options}</div>
    ${e.note ? g`<p class="soft note-line">${e.note}</p>` : y}
  </div>`;
}
// src/views/player.ts
var Co = 1 / 60;
function wo({ store: e }) {
	e.clock.playing ? e.pause() : e.play();
}
function To({ store: e }, t) {
	e.clock.pause(), e.seek(Math.max(0, e.clock.t + t * Co * e.clock.speed));
}
function Eo(e, t) {
	let { store: n, words: r, session: i, t: a } = e, o = `t-${t}`, s = i.drafts[o], c = so(e, "t", s), { label: l, symbol: u } = r.say.values.t, d = {
		key: o,
		label: l,
		symbol: u,
		unit: r.say.units.s,
		value: a,
		least: 0,
		most: 1e5,
		step: .1,
		grain: .01,
		origin: 0,
		ticks: [],
		text: r.fixed(a, 2),
		spoken: "",
		draft: s,
		fault: c,
		onText: (e) => {
			n.clock.pause(), n.draft(o, e);
			let t = oo("t", e);
			N("t", t) && n.seek(t);
		},
		onDone: () => c === null && n.draft(o, null),
		onSlide: (e) => n.seek(e),
		onHold: () => {}
	};
	return g`<span class="time">${t === "bar" ? g`<span class="time-name" aria-hidden="true">${C(u)}</span>` : ""}${Je(d, l)}</span>`;
}
function Do({ store: e, words: t }) {
	let n = Tt.map((e) => ({
		value: e,
		text: {
			.25: "¼",
			.5: "½",
			1: "1",
			2: "2"
		}[e],
		name: `${t.say.play.speed} ${t.given(e)}`
	}));
	return g`<span class="soft option">${t.say.play.speed} ${di(t.say.play.speed, n, e.clock.speed, (t) => e.set({ speed: t }))}</span>`;
}
function Oo(e) {
	let { store: t, words: n, state: r, session: i } = e, a = [
		...r.hide ? [] : [{
			value: "T",
			text: n.say.play.period
		}],
		{
			value: 8,
			text: n.with("8", n.say.units.s)
		},
		{
			value: 60,
			text: n.with("60", n.say.units.s)
		}
	], o = i.drafts.span, s = typeof r.span == "number" && !a.some(({ value: e }) => e === r.span), c = {
		key: "span",
		label: n.say.play.other,
		symbol: "",
		unit: n.say.units.s,
		value: typeof r.span == "number" ? r.span : 0,
		least: .1,
		most: 600,
		step: 1,
		grain: 1,
		origin: 0,
		ticks: [],
		text: s && typeof r.span == "number" ? n.typed(r.span) : "",
		spoken: "",
		draft: o,
		fault: so(e, "span", o),
		onText: (e) => {
			t.draft("span", e), ro(t, "span", oo("span", e));
		},
		onDone: () => so(e, "span", o) === null && t.draft("span", null),
		onSlide: (e) => ro(t, "span", e),
		onHold: () => {}
	};
	return g`<span class="soft option">${n.say.play.shown} ${di(n.say.play.shown, a, r.span, (e) => t.set({ span: e }))}<span class="span-field ${s ? "on" : ""}">${Je(c, n.say.play.other)}</span></span>`;
}
function ko(e, t, n, r) {
	let { store: i, words: a, t: o, session: s } = e, { play: c } = a.say;
	return So({
		playing: i.clock.playing,
		t: o,
		current: () => i.clock.t,
		from: t.from,
		to: t.to,
		ticks: n.filter((e) => e > t.from && e < t.to),
		names: {
			play: c.play,
			pause: c.pause,
			back: c.back,
			on: c.on,
			bar: c.bar
		},
		spoken: a.fill(c.timeText, { t: a.fixed(o, 2) }),
		field: (t) => Eo(e, t),
		options: [Do(e), r],
		note: s.reduced && !i.clock.playing ? c.reduced : null,
		onPlay: () => wo(e),
		onStep: (t) => To(e, t),
		onSeek: (e) => {
			i.clock.pause(), i.seek(Math.min(e, t.to - 1e-6 * (t.to - t.from)));
		},
		onHold: (e) => i.setSession({ held: e ? "time" : null })
	});
}
// src/widget.ts
var Ao = [
	"theta0",
	"velocity0",
	"length",
	"gravity"
], jo = 9.80665, Mo = 60, No = [
	li,
	oi,
	si,
	ci,
	ui
].join("\n").replace(/:root(\[[^\]]*\]|:not\([^)]*\))/g, ":host($1)").replaceAll(":root", ":host"), Po = null, Fo = /* @__PURE__ */ new Set();
Pe(() => {
	for (let e of Fo) e.schedule();
});
var Io = (e, t) => Number(e.get(t));
function Lo(e) {
	let t = e;
	for (; t;) {
		let e = getComputedStyle(t).backgroundColor.match(/[\d.]+/g) ?? [], [n = 0, r = 0, i = 0, a = 1] = e.map(Number);
		if (e.length > 0 && a > 0) return n + r + i < 384;
		let o = t.getRootNode();
		t = t.parentElement ?? (o instanceof ShadowRoot ? o.host : null);
	}
	return !1;
}
var Ro = class {
	traits;
	#e = new Ur(_n(""));
	#t = document.createElement("div");
	#n;
	#r = L((e, t, n, r, i) => e.motion({
		theta0: t,
		velocity0: n,
		length: r,
		gravity: i
	}));
	#i = null;
	#a = "";
	#o = !1;
	#s;
	#c = null;
	constructor(e, t) {
		this.traits = e, t.append(this.#t);
		let n = this.#t.attachShadow({ mode: "open" });
		n.append(Object.assign(document.createElement("style"), { textContent: No })), this.#n = n.appendChild(document.createElement("div")), this.#e.open({
			curves: [],
			span: "T"
		}), this.take(), this.#e.listen(() => {
			this.schedule(), this.#s ??= setTimeout(() => this.#l(), Mo);
		}), this.#t.addEventListener("keydown", (e) => e.stopPropagation());
	}
	take = () => {
		let { traits: e } = this, t = e.get("omega0");
		this.#c = typeof t == "number" ? t : null;
		let n = this.#c === null ? Io(e, "gravity") : jo, r = this.#c === null ? Io(e, "length") : jo / (this.#c * this.#c), i = {
			theta0: Io(e, "theta0"),
			velocity0: Io(e, "velocity0"),
			length: r,
			gravity: n
		}, { state: a } = this.#e;
		Ao.some((e) => !Object.is(a[e], i[e])) && this.#e.open({
			...i,
			t: 0
		});
	};
	#l() {
		this.#s = void 0;
		let { traits: e } = this, { state: t } = this.#e, n = (this.#c === null ? Ao : ["theta0", "velocity0"]).filter((n) => !Object.is(e.get(n), t[n]));
		for (let r of n) e.set(r, t[r]);
		let r = this.#c !== null && !Object.is(e.get("omega0"), this.#c);
		r && e.set("omega0", this.#c), (n.length > 0 || r) && e.save_changes();
	}
	async begin() {
		this.schedule();
		try {
			Po ??= Ir(Br), this.#i = await Po, matchMedia("(prefers-reduced-motion: reduce)").matches ? this.#e.setSession({ reduced: !0 }) : this.#e.play();
		} catch (e) {
			this.#a = String(e);
		}
		this.schedule();
	}
	schedule() {
		this.#o || (this.#o = !0, requestAnimationFrame(() => {
			this.#o = !1, !this.#t.isConnected && this.#i || (this.#d(), this.#e.clock.playing && this.schedule());
		}));
	}
	#u = L((e) => new Mt(jt(e ? [e] : navigator.languages)));
	#d() {
		this.#t.dataset.theme = Lo(this.#t.parentElement ?? this.#t) ? "dark" : "light";
		let e = this.#u(String(this.traits.get("lang") ?? "")), t = this.#i;
		if (!t) {
			ye(g`<div class="widget"><p class="waiting-line">${this.#a || "…"}</p></div>`, this.#n);
			return;
		}
		let n = this.#e, { state: r, session: i } = n, a = {
			store: n,
			state: r,
			session: i,
			words: e,
			model: t,
			motion: this.#r(t, r.theta0, r.velocity0, r.length, r.gravity),
			t: n.clock.t,
			rem: Le()
		};
		ye(this.#f(a), this.#n);
	}
	#f(e) {
		let { motion: t, t: n, state: r, session: i } = e, { from: a, to: o } = Yr(Jr(r, t), n), s = ai(t, r.curves, a, o, i.held !== null && i.held !== "time"), c = this.#c !== null;
		return g`<div class="widget" lang=${e.words.language} data-frequency=${c ? "omega0" : y}>
      <div class="column">${bo(e, [])}${c ? this.#p(e) : y}</div>
      <div class="column"><p class="sentence">${xo(e).replaceAll("*", "")}</p>
        ${qa(e, s)}${ko(e, s.window, Ma(s), Oo(e))}</div></div>`;
	}
	#p({ store: e, words: t, session: n }) {
		let r = this.#c ?? 1, i = (t) => {
			t > 0 && Number.isFinite(t) && (this.#c = t, e.open({
				length: jo / (t * t),
				t: 0
			}));
		};
		return Ze({
			key: "omega0",
			label: "omega0",
			symbol: "_ω_{0}",
			unit: t.say.units["rad/s"],
			value: r,
			least: 0,
			most: 10,
			step: .1,
			grain: .05,
			origin: 0,
			ticks: [1],
			text: t.typed(r),
			spoken: t.typed(r),
			draft: n.drafts.omega0,
			fault: null,
			onText: (t) => {
				e.draft("omega0", t), i(T(t));
			},
			onDone: () => e.draft("omega0", null),
			onSlide: (t) => {
				e.draft("omega0", null), i(t);
			},
			onHold: (t) => e.setSession({ held: t ? "omega0" : null })
		});
	}
};
function zo({ model: e, el: t }) {
	let n = new Ro(e, t);
	Fo.add(n);
	let r = [...Ao, "omega0"].map((e) => `change:${e}`);
	for (let t of r) e.on(t, n.take);
	return n.begin(), () => {
		for (let t of r) e.off(t, n.take);
		Fo.delete(n);
	};
}
var Bo = { render: zo };
export { Bo as default };
